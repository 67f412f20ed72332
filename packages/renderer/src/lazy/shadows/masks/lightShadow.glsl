// Shadow maps and cookies of lights, from the tiles of two atlases; the filters are three's own.
// three.js r187 shadowmap_pars_fragment; Reeves 1987 (PCF); Donnelly and Lauritzen 2006 (VSM); Jimenez 2014 (noise)
//? farol_cubeFace(vec3(2.0, 1.0, 1.0)) == vec3(0.75, 0.75, 0.0)
//? farol_cubeFace(vec3(0.0, 0.5, -2.0)) == vec3(0.5, 0.625, 5.0)
#include "lightTable"
#include "maskFeatures"
uniform highp mat3 farol_worldAxes; // from view space
uniform highp sampler2DShadow farol_shadowAtlas;
uniform highp sampler2D farol_lightAtlas; // linear colours, or mean and deviation of depths
uniform highp vec2 farol_atlasTexel; // a texel of each, as part of its side

// the five samples of three's disk before it is turned
const vec2 FAROL_DISK[5] = vec2[5](vec2(0.31622777, 0.0), vec2(-0.40387357, 0.36998127), vec2(0.06181932, -0.70439930),
  vec2(0.50905647, 0.66397403), vec2(-0.93418124, -0.16524351));

// the part of a cube map's face that a direction meets: x and y in 0..1, then the face (+x -x +y -y +z -z)
vec3 farol_cubeFace(const in vec3 direction) {
  vec3 size = abs(direction);
  vec3 side = vec3(direction.x < 0.0 ? -1.0 : 1.0, direction.y < 0.0 ? -1.0 : 1.0, direction.z < 0.0 ? -1.0 : 1.0);
  if (size.x >= size.y && size.x >= size.z)
    return vec3(vec2(side.x * direction.z, direction.y) / size.x * 0.5 + 0.5, 0.5 - 0.5 * side.x);
  if (size.y >= size.z) return vec3(vec2(side.y * direction.x, direction.z) / size.y * 0.5 + 0.5, 2.5 - 0.5 * side.y);
  return vec3(vec2(-side.z * direction.x, direction.y) / size.z * 0.5 + 0.5, 4.5 - 0.5 * side.z);
}

// texels of an atlas; tile: corner of the first face, texels a side of a face without its border; border: texels
vec2 farol_cubeTexel(const in vec3 tile, const in float border, const in vec3 face, const in bool nearest) {
  vec2 cell = vec2(mod(face.z, 3.0), floor(face.z / 3.0 + 0.01));
  vec2 texel = face.xy * tile.z;
  if (nearest) texel = min(floor(texel), tile.z - 1.0) + 0.5;
  return tile.xy + cell * (tile.z + 2.0 * border) + border + texel;
}

float farol_shadowTap(const in vec2 texel, const in float depth) {
  return textureLod(farol_shadowAtlas, vec3(texel * farol_atlasTexel.x, depth), 0.0);
}

// cosine and sine of the angle that the disk is turned by in a pixel
vec2 farol_diskTurn() {
  float angle = 6.28318530718 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  return vec2(cos(angle), sin(angle));
}

#ifdef FAROL_ONE_TURN
vec2 farol_turn; // found once a pixel
#define FAROL_TURN farol_turn
#else
#define FAROL_TURN farol_diskTurn()
#endif

// The samples of a disk: where its middle is in the atlas (0..1), with the depth there; how both change along the
// disk's axes.
struct FarolDisk {
  vec3 middle;
  vec3 alongX;
  vec3 alongY;
  vec4 bounds; // least and most x and y of samples
};

// one way for all, without branches, so that lighting goes on while the samples come
float farol_diskShadow(const in FarolDisk disk) {
  float lit = 0.0;
  for (int i = 0; i < 5; i++) {
    vec3 at = disk.middle + FAROL_DISK[i].x * disk.alongX + FAROL_DISK[i].y * disk.alongY;
#ifdef FAROL_SHADOW_MAPS
    at.xy = clamp(at.xy, disk.bounds.xy, disk.bounds.zw);
#endif
    lit += textureLod(farol_shadowAtlas, at, 0.0);
  }
  return lit * 0.2;
}

// tile: corner and size (texels); coord: across the map 0..1, and depth; reach: radius of the filter, as part of the
// map
FarolDisk farol_mapDisk(const in vec4 tile, const in vec3 coord, const in vec2 reach) {
  float texel = farol_atlasTexel.x;
  vec2 turn = FAROL_TURN;
  vec2 radius = reach * tile.zw * texel;
  return FarolDisk(vec3((tile.xy + coord.xy * tile.zw) * texel, coord.z), vec3(turn * radius, 0.0),
    vec3(vec2(-turn.y, turn.x) * radius, 0.0),
    vec4(tile.xy + 0.5, tile.xy + tile.zw - 0.5) * texel);
}

// of the first map that holds the place, of a directional light that has nearer maps, two a row
vec4 farol_cascadeTile(const in int record, const in vec4 tile, inout vec3 coord, const in int nearer) {
  int map = nearer;
#ifdef FAROL_SHADOW_CASCADES
  for (int i = 0; i < nearer; i++) {
    vec4 fit = farol_lightTexel(record + 2, i == 2 ? 0 : i + 2);
    vec2 there = coord.xy * fit.xz + fit.yw;
    if (max(abs(there.x - 0.5), abs(there.y - 0.5)) > 0.48) continue;
    coord.xy = there;
    map = i;
    break;
  }
#endif
  return vec4(tile.xy + vec2(map & 1, map >> 1) * tile.zw, tile.zw);
}

float farol_varianceShadow(const in vec4 tile, const in vec3 coord) {
  vec2 texel = clamp(tile.xy + coord.xy * tile.zw, tile.xy + 0.5, tile.xy + tile.zw - 0.5);
  vec2 moments = textureLod(farol_lightAtlas, texel * farol_atlasTexel.y, 0.0).rg;
  if (coord.z <= moments.x) return 1.0;
  float variance = max(moments.y * moments.y, 0.0000001);
  float beyond = coord.z - moments.x;
  return clamp((variance / (variance + beyond * beyond) - 0.3) / 0.65, 0.0, 1.0);
}

// Three's disk at right angles to the direction, in the plane of the face that it meets, to first order. With (p, q)
// where the direction meets the face (-1..1), l² = 1 + p² + q² and the disk's tangent t and bitangent b as three has
// them, the plane is met at (p, q) + l (t.xy - (p, q) t.z) and likewise for b. What lies beyond the face is in its
// border. depths: a and b of a face's depth a + b / distance along its axis; reach: radius of the filter, as part of a
// face
FarolDisk farol_cubeDisk(const in vec3 tile, const in float border, const in vec3 fromLight, const in vec2 depths,
  const in float reach) {
  vec3 size = abs(fromLight);
  vec3 side = vec3(fromLight.x < 0.0 ? -1.0 : 1.0, fromLight.y < 0.0 ? -1.0 : 1.0, fromLight.z < 0.0 ? -1.0 : 1.0);
  bool byX = size.x > size.z; // three's tangent is at right angles to y then, else to x
  bool isX = size.x >= size.y && size.x >= size.z;
  bool isY = size.y >= size.z && !isX;
  float face = isX ? 0.5 - 0.5 * side.x : isY ? 2.5 - 0.5 * side.y : 4.5 - 0.5 * side.z;
  float away = 1.0 / (isX ? size.x : isY ? size.y : size.z);
  vec2 p = (isX ? vec2(side.x * fromLight.z, fromLight.y) : isY ? vec2(side.y * fromLight.x, fromLight.z)
    : vec2(-side.z * fromLight.x, fromLight.y)) * away;
  float lengthSquared = 1.0 + dot(p, p);
  float depth = depths.y * away;
  bool isRound = isY && byX;
  // on x faces as on the others, with x and y exchanged
  vec2 q = isX ? p.yx : p;
  float tangentSquared = max(isRound ? lengthSquared - 1.0 : 1.0 + q.y * q.y, 1e-20);
  vec3 tangent = isRound ? vec3(-q.y, q.x, 0.0) : vec3(q.x * q.y, tangentSquared, depth * q.y);
  vec3 bitangent = isRound ? vec3(lengthSquared * q, depth * tangentSquared) : vec3(lengthSquared, 0.0, depth * q.x);
  float scale = inversesqrt(tangentSquared) * (isX ? reach : isY ? (byX ? side.y : -side.y) * reach : side.z * reach);
  tangent *= scale * sqrt(lengthSquared);
  bitangent *= isX ? -scale : scale;
  if (isX) {
    tangent.xy = tangent.yx;
    bitangent.xy = bitangent.yx;
  }
  vec2 turn = FAROL_TURN;
  float texel = farol_atlasTexel.x;
  vec3 unit = vec3(vec2(0.5 * tile.z * texel), 1.0);
  float row = face >= 3.0 ? 1.0 : 0.0;
  vec2 centre = (tile.xy + (vec2(face - 3.0 * row, row) + 0.5) * (tile.z + 2.0 * border)) * texel;
  return FarolDisk(vec3(centre, depths.x) + vec3(p, depth) * unit, (tangent * turn.x + bitangent * turn.y) * unit,
    (bitangent * turn.x - tangent * turn.y) * unit,
    vec4(0.0, 0.0, 1.0, 1.0));
}

// What a mask has beside where a point is: few texels, since they are fetched by every pixel for every light.
struct FarolMask {
  int kind;
  float cookie; // 0 none, 1 a map, 2 a cube
  bool extended; // the sixth texel counts; of a cube: the light has left its map, which has a place of its own
  vec3 tile; // corner, width (texels)
  float border; // round a face of a cube (texels)
  float normalBias; // m
  vec4 filtering; // of a map: bias, reach across and down; of a cube: its depths, reach; intensity
};

FarolMask farol_readMask(const in int record) {
  vec4 place = farol_lightTexel(record + 1, 0);
  int bits = int(place.z);
  return FarolMask(bits >> 15 & 7, float(bits >> 18 & 3), (bits & 1 << 20) != 0, vec3(place.xy, bits & 32767),
    float(1 << (bits >> 21)), place.w, farol_lightTexel(record + 1, 1));
}

// isPoint: that is known
bool farol_isCube(const in FarolMask mask, const in bool isPoint) {
  if (isPoint) return true;
#if defined( FAROL_SHADOW_CUBES ) && defined( FAROL_SHADOW_MAPS )
  return mask.kind == 3 || mask.kind == 4 || mask.cookie == 2.0;
#elif defined( FAROL_SHADOW_CUBES )
  return true;
#else
  return false;
#endif
}

// where a point is in a map (homogeneous, 0..1), or from a point light (m, world axes); toLight: from it to the light
// (m)
vec4 farol_maskCoord(const in int record, const in FarolMask mask, const in bool isPoint, const in vec3 toLight,
  const in vec3 positionVS, const in vec3 shadowNormalVS) {
  vec3 shift = shadowNormalVS * mask.normalBias;
  // lights that left their maps do not come as points for certain: those need not wait for the mask here
  if (farol_isCube(mask, isPoint))
    return vec4(farol_worldAxes * (shift - (!isPoint && mask.extended
      ? farol_lightTexel(record, 0).xyz - positionVS : toLight)), 1.0);
  return mat4(farol_lightTexel(record, 0), farol_lightTexel(record, 1), farol_lightTexel(record, 2),
    farol_lightTexel(record, 3)) * vec4(positionVS + shift, 1.0);
}

// 1 in the light, 0 in full shadow; PCF without branches, as far as only kinds of it have been met
float farol_litAt(const in int record, const in FarolMask mask, const in bool isPoint, const in vec4 coord) {
#ifdef FAROL_UNSHADOWED_MASKS
  if (mask.kind == 0) return 1.0;
#endif
  bool inside;
  float lit = 1.0;
  FarolDisk disk;
  if (farol_isCube(mask, isPoint)) {
#ifdef FAROL_SHADOW_CUBES
#ifdef FAROL_PCF_SHADOWS
    disk = farol_cubeDisk(mask.tile, mask.border, coord.xyz, mask.filtering.xy, mask.filtering.z);
    float depth = disk.middle.z;
#else
    float depth = mask.filtering.x + mask.filtering.y / max(max(abs(coord.x), abs(coord.y)), abs(coord.z));
#endif
    inside = depth >= 0.0 && depth <= 1.0; // neither before the nearest nor beyond the farthest
#ifdef FAROL_BASIC_SHADOWS
    if (mask.kind == 3)
      lit = farol_shadowTap(farol_cubeTexel(mask.tile, mask.border, farol_cubeFace(coord.xyz), true), depth);
#endif
#endif
  } else {
#ifdef FAROL_SHADOW_MAPS
    vec3 across = coord.xyz / coord.w + vec3(0.0, 0.0, mask.filtering.x);
    inside = all(greaterThanEqual(across.xy, vec2(0.0))) && all(lessThanEqual(across, vec3(1.0)));
    vec2 more = vec2(mask.tile.z, 0.0);
    if (mask.extended) more = farol_lightTexel(record + 1, 2).xy; // height, nearer maps
    vec4 tile = farol_cascadeTile(record, vec4(mask.tile, more.x), across, int(more.y));
#ifdef FAROL_BASIC_SHADOWS
    if (mask.kind == 1)
      lit = farol_shadowTap(
        clamp(floor(tile.xy + across.xy * tile.zw) + 0.5, tile.xy + 0.5, tile.xy + tile.zw - 0.5), across.z);
#endif
#ifdef FAROL_VARIANCE_SHADOWS
    if (mask.kind == 5) lit = farol_varianceShadow(tile, across);
#endif
#ifdef FAROL_PCF_SHADOWS
    disk = farol_mapDisk(tile, across, mask.filtering.yz);
#endif
#endif
  }
#ifdef FAROL_PCF_SHADOWS
#if defined( FAROL_BASIC_SHADOWS ) || defined( FAROL_VARIANCE_SHADOWS )
  if (mask.kind == 2 || mask.kind == 4)
#endif
  lit = farol_diskShadow(disk);
#endif
  return inside ? mix(1.0, lit, mask.filtering.w) : 1.0;
}

// of a mask whose light is not at hand
float farol_lightLit(const in int record, const in vec3 positionVS, const in vec3 shadowNormalVS) {
  FarolMask mask = farol_readMask(record);
  vec3 toLight = farol_lightTexel(record, 0).xyz - positionVS;
  return farol_litAt(record, mask, false, farol_maskCoord(record, mask, false, toLight, positionVS, shadowNormalVS));
}

// what the image of a light has there; kind: 1 a map, 2 a cube
vec3 farol_cookieAt(const in int record, const in vec4 coord, const in float kind) {
  vec4 tile = farol_lightTexel(record + 2, 0);
  vec2 texel;
  if (kind == 1.0) {
    vec3 across = coord.xyz / coord.w;
    if (any(greaterThanEqual(abs(across * 2.0 - 1.0), vec3(1.0)))) return vec3(1.0);
    texel = clamp(tile.xy + across.xy * tile.zw, tile.xy + 0.5, tile.xy + tile.zw - 0.5);
  } else texel = farol_cubeTexel(tile.xyz, 1.0, farol_cubeFace(coord.xyz), false);
  return textureLod(farol_lightAtlas, texel * farol_atlasTexel.y, 0.0).rgb;
}

// how much of the light a mask lets through to a point, by colour; isPoint: a point light's, for certain; receives:
// false where shadows do not count
vec3 farol_lightMask(const in int record, const in bool isPoint, const in vec3 toLight, const in vec3 positionVS,
  const in vec3 shadowNormalVS, const in bool receives) {
  FarolMask mask = farol_readMask(record);
  vec4 coord = farol_maskCoord(record, mask, isPoint, toLight, positionVS, shadowNormalVS);
  vec3 passed = vec3(1.0);
#ifdef FAROL_LIGHT_COOKIES
  if (mask.cookie > 0.0) passed = farol_cookieAt(record, coord, mask.cookie);
#endif
  float lit = farol_litAt(record, mask, isPoint, coord);
  return receives ? passed * lit : passed;
}
