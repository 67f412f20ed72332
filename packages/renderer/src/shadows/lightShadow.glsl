// Shadow maps and cookies of lights, from the tiles of two atlases; the filters are three's own.
// three.js r187 shadowmap_pars_fragment; Reeves et al. 1987 (PCF); Donnelly and Lauritzen 2006 (VSM); Jimenez 2014 (noise)
//? farol_cubeFace(vec3(2.0, 1.0, 1.0)) == vec3(0.75, 0.75, 0.0)
//? farol_cubeFace(vec3(0.0, 0.5, -2.0)) == vec3(0.5, 0.625, 5.0)
#include "lightTable"
#include "maskKinds"
uniform highp mat3 farol_worldAxes; // from view space
uniform highp sampler2DShadow farol_shadowAtlas;
uniform highp sampler2D farol_lightAtlas; // linear colours, or mean and deviation of depths

// the five samples of three's disk before it is turned
const vec2 FAROL_DISK[5] = vec2[5](vec2(0.31622777, 0.0), vec2(-0.40387357, 0.36998127), vec2(0.06181932, -0.70439930),
  vec2(0.50905647, 0.66397403), vec2(-0.93418124, -0.16524351));

// the part of a cube map's face that a direction meets: x and y in 0..1, then the face (+x -x +y -y +z -z)
vec3 farol_cubeFace(const in vec3 direction) {
  vec3 size = abs(direction);
  vec3 side = vec3(direction.x < 0.0 ? -1.0 : 1.0, direction.y < 0.0 ? -1.0 : 1.0, direction.z < 0.0 ? -1.0 : 1.0);
  if (size.x >= size.y && size.x >= size.z) return vec3(vec2(side.x * direction.z, direction.y) / size.x * 0.5 + 0.5, 0.5 - 0.5 * side.x);
  if (size.y >= size.z) return vec3(vec2(side.y * direction.x, direction.z) / size.y * 0.5 + 0.5, 2.5 - 0.5 * side.y);
  return vec3(vec2(-side.z * direction.x, direction.y) / size.z * 0.5 + 0.5, 4.5 - 0.5 * side.z);
}

// texels of an atlas; tile: corner of the first face, texels a side of a face without its border of one texel
vec2 farol_cubeTexel(const in vec3 tile, const in vec3 face, const in bool nearest) {
  vec2 cell = vec2(mod(face.z, 3.0), floor(face.z / 3.0 + 0.01));
  vec2 texel = face.xy * tile.z;
  if (nearest) texel = min(floor(texel), tile.z - 1.0) + 0.5;
  return tile.xy + cell * (tile.z + 2.0) + 1.0 + texel;
}

float farol_shadowTap(const in vec2 texel, const in float depth) {
  return textureLod(farol_shadowAtlas, vec3(texel / vec2(textureSize(farol_shadowAtlas, 0)), depth), 0.0);
}

// cosine and sine of the angle that the disk is turned by in a pixel
vec2 farol_diskTurn() {
  float angle = 6.28318530718 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  return vec2(cos(angle), sin(angle));
}

// tile: corner and size (texels); coord: across the map 0..1, and depth; reach: radius of the filter, as part of the map
float farol_mapShadow(const in int kind, const in vec4 tile, const in vec3 coord, const in vec2 reach) {
  vec2 texel = tile.xy + coord.xy * tile.zw;
  vec2 first = tile.xy + 0.5;
  vec2 last = tile.xy + tile.zw - 0.5;
#ifdef FAROL_BASIC_SHADOWS
  if (kind == 1) return farol_shadowTap(clamp(floor(texel) + 0.5, first, last), coord.z);
#endif
#ifdef FAROL_PCF_SHADOWS
  if (kind == 2) {
    vec2 size = 1.0 / vec2(textureSize(farol_shadowAtlas, 0));
    texel *= size;
    first *= size;
    last *= size;
    vec2 turn = farol_diskTurn();
    vec2 radius = reach * tile.zw * size;
    vec2 turnedX = turn * radius;
    vec2 turnedY = vec2(-turn.y, turn.x) * radius;
    float lit = 0.0;
    for (int i = 0; i < 5; i++) {
      vec2 at = clamp(texel + FAROL_DISK[i].x * turnedX + FAROL_DISK[i].y * turnedY, first, last);
      lit += textureLod(farol_shadowAtlas, vec3(at, coord.z), 0.0);
    }
    return lit * 0.2;
  }
#endif
#ifdef FAROL_VARIANCE_SHADOWS
  vec2 moments = textureLod(farol_lightAtlas, clamp(texel, first, last) / vec2(textureSize(farol_lightAtlas, 0)), 0.0).rg;
  if (coord.z <= moments.x) return 1.0;
  float variance = max(moments.y * moments.y, 0.0000001);
  float beyond = coord.z - moments.x;
  return clamp((variance / (variance + beyond * beyond) - 0.3) / 0.65, 0.0, 1.0);
#else
  return 1.0;
#endif
}

// the same in the first map that holds the place, of a directional light that has nearer maps, two a row
float farol_cascadeShadow(const in int record, const in int kind, const in vec4 tile, const in vec3 coord, const in vec2 reach, const in int nearer) {
  vec3 across = coord;
  int map = nearer;
#ifdef FAROL_SHADOW_CASCADES
  for (int i = 0; i < nearer; i++) {
    vec4 fit = farol_lightTexel(record + 2, i == 2 ? 0 : i + 2);
    vec2 there = coord.xy * fit.xz + fit.yw;
    if (max(abs(there.x - 0.5), abs(there.y - 0.5)) > 0.48) continue;
    across.xy = there;
    map = i;
    break;
  }
#endif
  return farol_mapShadow(kind, vec4(tile.xy + vec2(map & 1, map >> 1) * tile.zw, tile.zw), across, reach);
}

// a vector in world axes as a face of a cube has it: x and y across, z along its axis, for that which a direction of these sizes and sides meets
vec3 farol_acrossFace(const in vec3 v, const in vec3 size, const in vec3 side) {
  if (size.x >= size.y && size.x >= size.z) return vec3(side.x * v.z, v.y, side.x * v.x);
  if (size.y >= size.z) return vec3(side.y * v.x, v.z, side.y * v.y);
  return vec3(-side.z * v.x, v.y, side.z * v.z);
}

// the samples of a disk round a direction, each in the face that it meets
float farol_cubeDisk(const in vec3 tile, const in vec3 direction, const in vec3 turnedX, const in vec3 turnedY, const in vec2 depths) {
  float lit = 0.0;
  for (int i = 0; i < 5; i++) {
    vec3 towards = direction + FAROL_DISK[i].x * turnedX + FAROL_DISK[i].y * turnedY;
    vec3 size = abs(towards);
    float depth = depths.x + depths.y / max(max(size.x, size.y), size.z);
    lit += farol_shadowTap(farol_cubeTexel(tile, farol_cubeFace(towards), false), depth);
  }
  return lit;
}

// the same where all of them meet one face
float farol_faceDisk(const in vec3 tile, const in float cell, const in vec3 direction, const in vec3 turnedX, const in vec3 turnedY, const in vec2 depths) {
  vec2 texel = 1.0 / vec2(textureSize(farol_shadowAtlas, 0));
  vec2 cellOf = vec2(mod(cell, 3.0), floor(cell / 3.0 + 0.01));
  vec2 centre = (tile.xy + (cellOf + 0.5) * (tile.z + 2.0)) * texel;
  vec2 halfSize = 0.5 * tile.z * texel;
  float lit = 0.0;
  for (int i = 0; i < 5; i++) {
    vec3 towards = direction + FAROL_DISK[i].x * turnedX + FAROL_DISK[i].y * turnedY;
    vec3 scaled = vec3(halfSize * towards.xy, depths.y) / towards.z;
    lit += textureLod(farol_shadowAtlas, vec3(centre, depths.x) + scaled, 0.0);
  }
  return lit;
}

// depths: a and b of a face's depth a + b / distance along its axis; reach: radius of the filter, as part of a face
float farol_cubeShadow(const in int kind, const in vec3 tile, const in vec3 fromLight, const in vec2 depths, const in float reach) {
  vec3 size = abs(fromLight);
  float along = max(max(size.x, size.y), size.z);
  float depthAlong = depths.x + depths.y / along;
  if (depthAlong < 0.0 || depthAlong > 1.0) return 1.0; // before the nearest or beyond the farthest
#ifdef FAROL_BASIC_SHADOWS
  if (kind == 3) return farol_shadowTap(farol_cubeTexel(tile, farol_cubeFace(fromLight), true), depthAlong);
#endif
#ifdef FAROL_PCF_SHADOWS
  float scale = inversesqrt(dot(fromLight, fromLight));
  vec3 direction = fromLight * scale;
  size *= scale;
  vec2 faceDepths = vec2(depths.x, depths.y * scale);
  vec3 tangent = size.x > size.z ? vec3(-direction.z, 0.0, direction.x) : vec3(0.0, direction.z, -direction.y);
  tangent *= inversesqrt(dot(tangent, tangent));
  vec3 bitangent = cross(direction, tangent);
  vec2 turn = farol_diskTurn() * reach;
  vec3 turnedX = tangent * turn.x + bitangent * turn.y;
  vec3 turnedY = bitangent * turn.x - tangent * turn.y;
  along *= scale;
  float second = size.x + size.y + size.z - along - min(min(size.x, size.y), size.z);
  if (second + 2.0 * reach > along) return farol_cubeDisk(tile, direction, turnedX, turnedY, faceDepths) * 0.2;
  vec3 side = vec3(direction.x < 0.0 ? -1.0 : 1.0, direction.y < 0.0 ? -1.0 : 1.0, direction.z < 0.0 ? -1.0 : 1.0);
  bool isX = size.x >= size.y && size.x >= size.z;
  bool isY = size.y >= size.z;
  float cell = isX ? 0.5 - 0.5 * side.x : isY ? 2.5 - 0.5 * side.y : 4.5 - 0.5 * side.z;
  return 0.2 * farol_faceDisk(tile, cell, farol_acrossFace(direction, size, side), farol_acrossFace(turnedX, size, side),
    farol_acrossFace(turnedY, size, side), faceDepths);
#else
  return 1.0;
#endif
}

// What a mask has beside where a point is: few texels, since they are fetched by every pixel for every light.
struct FarolMask {
  int kind;
  float cookie; // 0 none, 1 a map, 2 a cube
  bool extended; // the sixth texel counts
  vec3 tile; // corner, width (texels)
  float normalBias; // m
  vec4 filtering; // of a map: bias, reach across and down; of a cube: its depths, reach; intensity
};

FarolMask farol_readMask(const in int record) {
  vec4 place = farol_lightTexel(record + 1, 0);
  int bits = int(place.z);
  return FarolMask(bits >> 15 & 7, float(bits >> 18 & 3), (bits & 1 << 20) != 0, vec3(place.xy, bits & 32767), place.w, farol_lightTexel(record + 1, 1));
}

bool farol_isCube(const in FarolMask mask) {
#if defined( FAROL_SHADOW_CUBES ) && defined( FAROL_SHADOW_MAPS )
  return mask.kind == 3 || mask.kind == 4 || mask.cookie == 2.0;
#elif defined( FAROL_SHADOW_CUBES )
  return true;
#else
  return false;
#endif
}

// where a point is in a map (homogeneous, 0..1), or from a point light (m, world axes); toLight: from it to the light (m)
vec4 farol_maskCoord(const in int record, const in FarolMask mask, const in vec3 toLight, const in vec3 positionVS, const in vec3 shadowNormalVS) {
  vec3 shift = shadowNormalVS * mask.normalBias;
  if (farol_isCube(mask)) return vec4(farol_worldAxes * (shift - toLight), 1.0);
  return mat4(farol_lightTexel(record, 0), farol_lightTexel(record, 1), farol_lightTexel(record, 2), farol_lightTexel(record, 3)) * vec4(positionVS + shift, 1.0);
}

// 1 in the light, 0 in full shadow
float farol_litAt(const in int record, const in FarolMask mask, const in vec4 coord) {
  if (mask.kind == 0) return 1.0;
  float lit = 1.0;
  if (farol_isCube(mask)) {
#ifdef FAROL_SHADOW_CUBES
    lit = farol_cubeShadow(mask.kind, mask.tile, coord.xyz, mask.filtering.xy, mask.filtering.z);
#endif
  } else {
#ifdef FAROL_SHADOW_MAPS
    vec3 across = coord.xyz / coord.w + vec3(0.0, 0.0, mask.filtering.x);
    bool inside = all(greaterThanEqual(across.xy, vec2(0.0))) && all(lessThanEqual(across, vec3(1.0)));
    if (inside) {
      vec2 more = mask.extended ? farol_lightTexel(record + 1, 2).xy : vec2(mask.tile.z, 0.0); // height, nearer maps
      lit = farol_cascadeShadow(record, mask.kind, vec4(mask.tile, more.x), across, mask.filtering.yz, int(more.y));
    }
#endif
  }
  return mix(1.0, lit, mask.filtering.w);
}

// of a mask whose light is not at hand
float farol_lightLit(const in int record, const in vec3 positionVS, const in vec3 shadowNormalVS) {
  FarolMask mask = farol_readMask(record);
  vec3 toLight = farol_lightTexel(record, 0).xyz - positionVS;
  return farol_litAt(record, mask, farol_maskCoord(record, mask, toLight, positionVS, shadowNormalVS));
}

// what the image of a light has there; kind: 1 a map, 2 a cube
vec3 farol_cookieAt(const in int record, const in vec4 coord, const in float kind) {
  vec4 tile = farol_lightTexel(record + 2, 0);
  vec2 texel;
  if (kind == 1.0) {
    vec3 across = coord.xyz / coord.w;
    if (any(greaterThanEqual(abs(across * 2.0 - 1.0), vec3(1.0)))) return vec3(1.0);
    texel = clamp(tile.xy + across.xy * tile.zw, tile.xy + 0.5, tile.xy + tile.zw - 0.5);
  } else texel = farol_cubeTexel(tile.xyz, farol_cubeFace(coord.xyz), false);
  return textureLod(farol_lightAtlas, texel / vec2(textureSize(farol_lightAtlas, 0)), 0.0).rgb;
}

// how much of the light a mask lets through to a point, by colour; receives: false where shadows do not count
vec3 farol_lightMask(const in int record, const in vec3 toLight, const in vec3 positionVS, const in vec3 shadowNormalVS, const in bool receives) {
  FarolMask mask = farol_readMask(record);
  vec4 coord = farol_maskCoord(record, mask, toLight, positionVS, shadowNormalVS);
  vec3 passed = vec3(1.0);
#ifdef FAROL_LIGHT_COOKIES
  if (mask.cookie > 0.0) passed = farol_cookieAt(record, coord, mask.cookie);
#endif
  if (receives) passed *= farol_litAt(record, mask, coord);
  return passed;
}
