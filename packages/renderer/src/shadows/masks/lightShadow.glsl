// Samples the shadow maps, cookies and profiles of lights in regions of two atlases; the filters are three's own.
// three.js r187 shadowmap_pars_fragment; Reeves 1987 (PCF); Donnelly and Lauritzen 2006 (VSM); Jimenez 2014 (noise)
//? farol_cubeFace(vec3(2.0, 1.0, 1.0)) == vec3(0.75, 0.75, 0.0)
//? farol_cubeFace(vec3(0.0, 0.5, -2.0)) == vec3(0.5, 0.625, 5.0)
#include "lightTable"
#include "maskFeatures"
#include "maskRecord"
#include "lightImage"
#include "targetPixel"
uniform highp mat3 farol_worldAxes; // rotation from view space to world space
uniform highp sampler2DShadow farol_shadowAtlas;

// the five sample offsets of three's PCF disk, before its rotation
const vec2 FAROL_DISK[5] = vec2[5](vec2(0.31622777, 0.0), vec2(-0.40387357, 0.36998127), vec2(0.06181932, -0.70439930),
  vec2(0.50905647, 0.66397403), vec2(-0.93418124, -0.16524351));

// coordinates of a direction in a cube map: x and y in the face (0..1), index of the face (+x -x +y -y +z -z)
vec3 farol_cubeFace(const in vec3 direction) {
  vec3 size = abs(direction);
  vec3 side = vec3(direction.x < 0.0 ? -1.0 : 1.0, direction.y < 0.0 ? -1.0 : 1.0, direction.z < 0.0 ? -1.0 : 1.0);
  if (size.x >= size.y && size.x >= size.z)
    return vec3(vec2(side.x * direction.z, direction.y) / size.x * 0.5 + 0.5, 0.5 - 0.5 * side.x);
  if (size.y >= size.z) return vec3(vec2(side.y * direction.x, direction.z) / size.y * 0.5 + 0.5, 2.5 - 0.5 * side.y);
  return vec3(vec2(-side.z * direction.x, direction.y) / size.z * 0.5 + 0.5, 4.5 - 0.5 * side.z);
}

// place in the atlas (texels) of a point on a cube's face; region: corner, side of a face without border (texels)
vec2 farol_cubeTexel(const in vec3 region, const in float border, const in vec3 face, const in bool nearest) {
  vec2 cell = vec2(mod(face.z, 3.0), floor(face.z / 3.0 + 0.01));
  vec2 texel = face.xy * region.z;
  if (nearest) texel = min(floor(texel), region.z - 1.0) + 0.5;
  return region.xy + cell * (region.z + 2.0 * border) + border + texel;
}

float farol_shadowTap(const in vec2 texel, const in float depth) {
  return textureLod(farol_shadowAtlas, vec3(texel * farol_atlasTexel.x, depth), 0.0);
}

// cosine and sine of the PCF disk's rotation in this pixel
vec2 farol_diskTurn() {
#ifdef FAROL_PER_VERTEX
  return vec2(1.0, 0.0);
#else
  float angle = 6.28318530718 * fract(52.9829189 * fract(dot(farol_targetPixel(), vec2(0.06711056, 0.00583715))));
  return vec2(cos(angle), sin(angle));
#endif
}

#ifdef FAROL_ONE_TURN
vec2 farol_turn; // farol_diskTurn(), computed once a pixel
#define FAROL_TURN farol_turn
#else
#define FAROL_TURN farol_diskTurn()
#endif

// Samples of a disk: coordinates in the atlas (0..1) and the depths compared there.
struct FarolDisk {
  vec3 middle;
  vec3 alongX; // change along the disk's axes: place in the atlas (0 to 1) and depth
  vec3 alongY;
  vec4 bounds; // least x, y and greatest x, y (0..1 in the atlas) that samples are clamped to
};

// lit share of a disk's samples; without branches, so that other lighting is computed while samples are fetched
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

// region: corner and size (texels); coord: place in the map (0..1), depth; reach: filter radius, as part of the map
FarolDisk farol_mapDisk(const in vec4 region, const in vec3 coord, const in vec2 reach) {
  float texel = farol_atlasTexel.x;
  vec2 turn = FAROL_TURN;
  vec2 radius = reach * region.zw * texel;
  return FarolDisk(vec3((region.xy + coord.xy * region.zw) * texel, coord.z), vec3(turn * radius, 0.0),
    vec3(vec2(-turn.y, turn.x) * radius, 0.0),
    vec4(region.xy + 0.5, region.xy + region.zw - 0.5) * texel);
}

// region of the first cascade that contains coord, else of the whole shadow camera's map; transforms coord into it;
// the regions lie two in a row of the atlas
vec4 farol_cascadeRegion(const in int record, const in vec4 region, inout vec3 coord, const in int cascades) {
  int map = cascades;
#ifdef FAROL_SHADOW_CASCADES
  for (int i = 0; i < cascades; i++) {
    vec4 fit = farol_maskFit(record, i);
    vec2 there = coord.xy * fit.xz + fit.yw;
    if (max(abs(there.x - 0.5), abs(there.y - 0.5)) > 0.48) continue;
    coord.xy = there;
    map = i;
    break;
  }
#endif
  return vec4(region.xy + vec2(map & 1, map >> 1) * region.zw, region.zw);
}

// 1 in the light, 0 in full shadow: upper bound from mean and deviation of depths, light bleeding cut off
// away: 1 where depth grows with distance, -1 where it is reversed
float farol_varianceShadow(const in vec4 region, const in vec3 coord, const in float away) {
  vec2 texel = clamp(region.xy + coord.xy * region.zw, region.xy + 0.5, region.xy + region.zw - 0.5);
  vec2 moments = textureLod(farol_lightAtlas, texel * farol_atlasTexel.y, 0.0).rg;
  float beyond = (coord.z - moments.x) * away;
  if (beyond <= 0.0) return 1.0;
  float variance = max(moments.y * moments.y, 0.0000001);
  return clamp((variance / (variance + beyond * beyond) - 0.3) / 0.65, 0.0, 1.0);
}

// Three's disk at right angles to the direction, projected to the plane of the cube's face, to first order. With
// (p, q) where the direction hits the face (-1..1), l² = 1 + p² + q² and three's tangent t and bitangent b of the
// disk, t projects to (p, q) + l (t.xy - (p, q) t.z), and b likewise. Samples beyond the face are in its border.
// depths: a and b of the depth a + b / distance along the face's axis; reach: radius of the filter, as part of a face
FarolDisk farol_cubeDisk(const in vec3 region, const in float border, const in vec3 fromLight, const in vec2 depths,
  const in float reach) {
  vec3 size = abs(fromLight);
  vec3 side = vec3(fromLight.x < 0.0 ? -1.0 : 1.0, fromLight.y < 0.0 ? -1.0 : 1.0, fromLight.z < 0.0 ? -1.0 : 1.0);
  bool byX = size.x > size.z; // whether three's tangent is at right angles to y, else to x
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
  vec3 unit = vec3(vec2(0.5 * region.z * texel), 1.0);
  float row = face >= 3.0 ? 1.0 : 0.0;
  vec2 centre = (region.xy + (vec2(face - 3.0 * row, row) + 0.5) * (region.z + 2.0 * border)) * texel;
  return FarolDisk(vec3(centre, depths.x) + vec3(p, depth) * unit, (tangent * turn.x + bitangent * turn.y) * unit,
    (bitangent * turn.x - tangent * turn.y) * unit,
    vec4(0.0, 0.0, 1.0, 1.0));
}

// Values of a mask that every pixel reads, see maskLayout.ts.
struct FarolMask {
  int lookup; // sampling of the shadow map, a FAROL_LOOKUP_…
  int cookie; // kind of cookie: FAROL_COOKIE_…
#ifdef FAROL_LIGHT_PROFILES
  bool hasProfile;
#endif
  bool isExtended;
  vec3 region; // corner of the map's region in the atlas, width of a face (texels)
  float border; // border round a cube's face (texels)
  float normalBias; // offset of the lookup along the surface's normal (m)
  vec4 filtering;
};

FarolMask farol_readMask(const in int record) {
  vec4 place = farol_maskPlace(record);
  int cookie = farol_maskCookieShape(place);
#ifdef FAROL_LIGHT_PROFILES
  bool hasProfile = cookie == FAROL_COOKIE_PROFILE;
  if (hasProfile) cookie = farol_maskProfileCookie(record);
#define FAROL_HAS_PROFILE hasProfile,
#else
#define FAROL_HAS_PROFILE
#endif
  return FarolMask(farol_maskLookup(place), cookie, FAROL_HAS_PROFILE farol_maskIsExtended(place),
    vec3(farol_maskCorner(place), farol_maskWidth(place)), float(farol_maskBorder(place)), farol_maskNormalBias(place),
    farol_maskFiltering(record));
}

bool farol_looksUpCube(const in FarolMask mask) {
  return mask.lookup == FAROL_LOOKUP_CUBE_BASIC || mask.lookup == FAROL_LOOKUP_CUBE_PCF
    || mask.lookup == FAROL_LOOKUP_SOFT;
}

// isPoint: the light is known to be a point light
bool farol_isCube(const in FarolMask mask, const in bool isPoint) {
  if (isPoint) return true;
#if defined( FAROL_SHADOW_CUBES ) && defined( FAROL_SHADOW_MAPS )
  return farol_looksUpCube(mask) || mask.cookie == FAROL_COOKIE_CUBE;
#elif defined( FAROL_SHADOW_CUBES )
  return true;
#else
  return false;
#endif
}

// coordinates of a surface in a map (homogeneous, 0..1), or vector from a point light to the surface (m, world)
// toLight: from the surface to the light (view space, m)
vec4 farol_maskCoord(const in int record, const in FarolMask mask, const in bool isPoint, const in vec3 toLight,
  const in vec3 positionVS, const in vec3 shadowNormalVS) {
  vec3 shift = shadowNormalVS * mask.normalBias;
  // isPoint is false for lights that have moved from where their maps were drawn; other point lights need not read
  // the mask here
  if (farol_isCube(mask, isPoint))
    return vec4(farol_worldAxes * (shift - (!isPoint && mask.isExtended
      ? farol_maskPosition(record) - positionVS : toLight)), 1.0);
  return farol_maskMatrix(record) * vec4(positionVS + shift, 1.0);
}

// 1 in the light, 0 in full shadow; without branches while PCF is the only kind of shadow map in use
float farol_litAt(const in int record, const in FarolMask mask, const in bool isPoint, const in vec4 coord) {
#ifdef FAROL_UNSHADOWED_MASKS
  if (mask.lookup == FAROL_LOOKUP_NONE) return 1.0;
#endif
  bool inside;
  float lit = 1.0;
  FarolDisk disk;
  if (farol_isCube(mask, isPoint)) {
#ifdef FAROL_SHADOW_CUBES
#if ( FAROL_SHADOW_LOOKUPS & 2 ) != 0 // PCF shadow maps
    disk = farol_cubeDisk(mask.region, mask.border, coord.xyz, mask.filtering.xy, mask.filtering.z);
    float depth = disk.middle.z;
#else
    float depth = mask.filtering.x + mask.filtering.y / max(max(abs(coord.x), abs(coord.y)), abs(coord.z));
#endif
    inside = depth >= 0.0 && depth <= 1.0; // whether the surface is between the shadow camera's near and far planes
#if ( FAROL_SHADOW_LOOKUPS & 1 ) != 0 // basic shadow maps
    if (mask.lookup == FAROL_LOOKUP_CUBE_BASIC)
      lit = farol_shadowTap(farol_cubeTexel(mask.region, mask.border, farol_cubeFace(coord.xyz), true), depth);
#endif
#endif
  } else {
#ifdef FAROL_SHADOW_MAPS
    vec3 across = coord.xyz / coord.w + vec3(0.0, 0.0, mask.filtering.x);
    inside = all(greaterThanEqual(across.xy, vec2(0.0))) && all(lessThanEqual(across, vec3(1.0)));
    vec2 extent = vec2(mask.region.z, 0.0); // height of the map (texels), number of its cascades
    if (mask.isExtended) extent = farol_maskHeightAndCascades(record);
    vec4 region = farol_cascadeRegion(record, vec4(mask.region, extent.x), across, int(extent.y));
#if ( FAROL_SHADOW_LOOKUPS & 1 ) != 0 // basic shadow maps
    if (mask.lookup == FAROL_LOOKUP_BASIC)
      lit = farol_shadowTap(
        clamp(floor(region.xy + across.xy * region.zw) + 0.5, region.xy + 0.5, region.xy + region.zw - 0.5), across.z);
#endif
#if ( FAROL_SHADOW_LOOKUPS & 4 ) != 0 // variance shadow maps
    if (mask.lookup == FAROL_LOOKUP_VARIANCE) lit = farol_varianceShadow(region, across, mask.filtering.y);
#endif
#if ( FAROL_SHADOW_LOOKUPS & 2 ) != 0 // PCF shadow maps
    disk = farol_mapDisk(region, across, mask.filtering.yz);
#endif
#endif
  }
#if ( FAROL_SHADOW_LOOKUPS & 2 ) != 0 // PCF shadow maps
#if FAROL_SHADOW_LOOKUPS != 2
  if (mask.lookup == FAROL_LOOKUP_PCF || mask.lookup == FAROL_LOOKUP_CUBE_PCF)
#endif
  lit = farol_diskShadow(disk);
#endif
  return inside ? mix(1.0, lit, mask.filtering.w) : 1.0;
}

#ifdef FAROL_SOFT_SHADOWS
const int FAROL_SEARCHES = 16; // number of directions in which blockers are searched
const int FAROL_HALVINGS = 4; // number of halvings of the distance to the surface in a search for a blocker
const int FAROL_SOFT_TAPS = 20;

// 0 if the map has a blocker between the light and a place (m, relative to the light), else 1
float farol_softTap(const in FarolMask mask, const in vec3 place) {
  float depth = mask.filtering.x + mask.filtering.y / max(max(abs(place.x), abs(place.y)), abs(place.z));
  return farol_shadowTap(farol_cubeTexel(mask.region, mask.border, farol_cubeFace(place), false),
    clamp(depth, 0.0, 1.0));
}

// i-th sample of a disk, by Vogel's spiral
vec2 farol_spiral(const in int i, const in vec2 turn) {
  float angle = 2.3999632297 * float(i);
  return cos(angle) * turn + sin(angle) * vec2(-turn.y, turn.x);
}

// Percentage-closer soft shadows of an area light, from its centre. The sampler only compares depths, so a blocker's
// distance is found by bisection between light and surface.
// Fernando 2005, Percentage-Closer Soft Shadows
// fromLight: vector to the surface (m, world axes)
float farol_softShadow(const in FarolMask mask, const in vec3 fromLight, const in vec3 vertexNormal) {
  float away = length(fromLight);
  vec3 forward = fromLight / away;
  vec3 normal = faceforward(vertexNormal, forward, vertexNormal); // back faces are lit too
  vec3 right = normalize(cross(forward, abs(forward.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
  vec3 up = cross(right, forward);
  float facing = min(dot(normal, forward), -0.05);
  float size = mask.filtering.z / away; // size of the light over its distance from the surface
  vec2 turn = FAROL_TURN;
  float blockers = 0.0;
  float distances = 0.0; // sum of the blockers' distances, as parts of the distance to the surface
  for (int i = 0; i < FAROL_SEARCHES; i++) {
    // more directions near the disk's middle, where blockers near the surface are
    float part = (float(i) + 0.5) / float(FAROL_SEARCHES);
    vec2 at = farol_spiral(i, turn) * (part * min(2.0 * size, 1.0));
    vec3 direction = forward + at.x * right + at.y * up;
    // end of the search: where the direction meets the plane of the surface
    vec3 end = direction * (away * clamp(facing / min(dot(normal, direction), -0.02), 0.3, 2.0));
    if (farol_softTap(mask, end * 0.99) > 0.5) continue;
    float near = 0.0;
    float far = 1.0;
    for (int k = 0; k < FAROL_HALVINGS; k++) {
      float middle = 0.5 * (near + far);
      if (farol_softTap(mask, end * middle) > 0.5) near = middle;
      else far = middle;
    }
    blockers += part;
    distances += part * 0.5 * (near + far);
  }
  if (blockers == 0.0) return 1.0;
  float radius = min(size * max(blockers / distances - 1.0, 0.02), 1.5);
  float sum = 0.0;
  for (int i = 0; i < FAROL_SOFT_TAPS; i++) {
    vec2 at = farol_spiral(i, turn) * (sqrt((float(i) + 0.5) / float(FAROL_SOFT_TAPS)) * radius);
    vec3 direction = forward + at.x * right + at.y * up;
    sum += farol_softTap(mask, direction * (away * clamp(facing / min(dot(normal, direction), -0.02), 0.3, 2.0)));
  }
  return mix(1.0, sum / float(FAROL_SOFT_TAPS), mask.filtering.w);
}
#endif

// share of a light that its shadow map lets through, by the mask's filter
float farol_filteredAt(const in int record, const in FarolMask mask, const in bool isPoint, const in vec4 coord,
  const in vec3 shadowNormalVS) {
#ifdef FAROL_SOFT_SHADOWS
  if (mask.lookup == FAROL_LOOKUP_SOFT) return farol_softShadow(mask, coord.xyz, farol_worldAxes * shadowNormalVS);
#endif
  return farol_litAt(record, mask, isPoint, coord);
}

// share of a light that its shadow map lets through; reads the mask by its record
float farol_lightLit(const in int record, const in vec3 positionVS, const in vec3 shadowNormalVS) {
  FarolMask mask = farol_readMask(record);
  vec3 toLight = farol_maskPosition(record) - positionVS;
  vec4 coord = farol_maskCoord(record, mask, false, toLight, positionVS, shadowNormalVS);
  return farol_filteredAt(record, mask, false, coord, shadowNormalVS);
}

#ifdef FAROL_LIGHT_PROFILES
// factor of a light's intensity in the direction of a surface, by its photometric profile
float farol_profileAt(const in int record, const in vec3 toLight) {
  vec3 across = farol_maskProfileAcross(record);
  vec3 down = farol_maskProfileDown(record);
  vec4 region = farol_maskProfile(record);
  vec2 level = -vec2(dot(toLight, across), dot(toLight, cross(across, down)));
  float vertical = atan(length(level), -dot(toLight, down)) * 0.3183098862;
  float horizontal = level == vec2(0.0) ? 0.0 : fract(atan(level.y, level.x) * 0.1591549431);
  // interpolated here: GPUs filter with weights of 8 bits, off by up to 2e-3 of the step between two texels
  vec2 place = vec2(vertical, horizontal) * (region.zw - 1.0);
  vec2 low = clamp(floor(place), vec2(0.0), max(region.zw - 2.0, 0.0));
  vec2 part = place - low;
  ivec2 first = ivec2(region.xy + low);
  ivec2 last = ivec2(region.xy + min(low + 1.0, region.zw - 1.0));
  vec4 corners = vec4(
    texelFetch(farol_lightAtlas, first, 0).r, texelFetch(farol_lightAtlas, ivec2(last.x, first.y), 0).r,
    texelFetch(farol_lightAtlas, ivec2(first.x, last.y), 0).r, texelFetch(farol_lightAtlas, last, 0).r);
  vec2 rows = mix(corners.xz, corners.yw, part.x);
  return mix(rows.x, rows.y, part.y);
}
#endif

// colour of a light that its mask lets through
// isPoint: the light is known to be a point light; receives: whether shadows apply; else only the cookie
vec3 farol_lightMask(const in int record, const in bool isPoint, const in vec3 toLight, const in vec3 positionVS,
  const in vec3 shadowNormalVS, const in bool receives) {
  FarolMask mask = farol_readMask(record);
  vec4 coord = farol_maskCoord(record, mask, isPoint, toLight, positionVS, shadowNormalVS);
  vec3 passed = vec3(1.0);
#ifdef FAROL_LIGHT_COOKIES
  bool isCube = mask.cookie != FAROL_COOKIE_MAP;
  if (mask.cookie != FAROL_COOKIE_NONE)
    passed = farol_cookieAt(record, coord, isCube, farol_worldAxes, positionVS, shadowNormalVS);
#endif
#ifdef FAROL_LIGHT_PROFILES
  if (mask.hasProfile) passed *= farol_profileAt(record, toLight);
#endif
  float lit = farol_filteredAt(record, mask, isPoint, coord, shadowNormalVS);
  return receives ? passed * lit : passed;
}
