// Marks lights that light all surfaces of a screen tile, or none, by the depth bounds of their shadow maps: pixels then
// need no sample of these maps.
// Farol; Olsson et al. 2014, Efficient Virtual Shadow Maps for Many Lights, for culling lights by shadow maps
#include "lightShadow"
#include "lightTiles"
#include "unproject"
uniform highp usampler2D farol_tilePlanes;
uniform highp usampler2D farol_shadowBounds;
uniform highp usampler2D farol_gridMasks;
uniform highp ivec4 farol_grid;
uniform highp vec2 farol_size;
uniform highp int farol_tileShadowWords;
// for two words (32 lights each): bits of lights that light all of the tile, then of those that light none; both
// bits: see farol_tileShadows
layout(location = 0) out highp uvec4 farol_marks;

const int FAROL_MOST_BLOCKS = 6; // largest side of the region of a map that a tile covers (blocks)

vec3 farol_corners[8]; // corners of a box round the tile's surfaces (view space, m)
#ifdef FAROL_SHADOW_CUBES
vec3 farol_worldCorners[8]; // the tile's corners relative to the camera, along the world's axes (m)
#endif

// finds the corners of a tile's surfaces; false where the tile has none
bool farol_findCorners(const in ivec2 tile) {
  ivec2 block = tile * 2;
  ivec2 last = min(block + 1, (ivec2(farol_size) + 3) / 4 - 1);
  vec4 a = uintBitsToFloat(texelFetch(farol_tilePlanes, block, 0));
  vec4 b = uintBitsToFloat(texelFetch(farol_tilePlanes, ivec2(last.x, block.y), 0));
  vec4 c = uintBitsToFloat(texelFetch(farol_tilePlanes, ivec2(block.x, last.y), 0));
  vec4 d = uintBitsToFloat(texelFetch(farol_tilePlanes, last, 0));
  float least = min(min(a.x, b.x), min(c.x, d.x));
  float most = max(max(a.y, b.y), max(c.y, d.y));
  if (most < least) return false;
  float rounding = 1e-6 * max(abs(least), abs(most));
  bool known = true;
  for (int i = 0; i < 8; i++) {
    vec2 away = vec2((i & 1) == 0 ? -0.5 : 0.5, (i & 2) == 0 ? -0.5 : 0.5) * float(FAROL_TILE - 1);
    float e = dot(a.zw, away) + ((i & 4) == 0 ? least - rounding : most + rounding);
    float z = (farol_unprojectZ.x + farol_unprojectZ.y * e) / (farol_unprojectZ.z + farol_unprojectZ.w * e);
    vec2 uv = (vec2(tile * FAROL_TILE) + 0.5 * float(FAROL_TILE) + away) / farol_size;
    farol_corners[i] = vec3((uv * 2.0 - 1.0 + farol_unprojectXY.zw) * farol_unprojectXY.xy
      * mix(1.0, -z, farol_perspective), z);
#ifdef FAROL_SHADOW_CUBES
    farol_worldCorners[i] = farol_worldAxes * farol_corners[i];
#endif
    known = known && z < 0.0 && z > -1e6;
  }
  return known;
}

// least and greatest of (a ± shift) / (c ± by), c - by above 0
vec2 farol_ratio(const in float a, const in float shift, const in float c, const in float by) {
  vec2 scale = 1.0 / vec2(c - by, c + by);
  float low = a - shift;
  float high = a + shift;
  return vec2(low * (low < 0.0 ? scale.x : scale.y), high * (high < 0.0 ? scale.y : scale.x));
}

// Result of comparing a shadow map with the tile's surfaces.
struct FarolComparison {
  bool isLit; // nothing casts a shadow on any surface of the tile
  bool isDark; // something casts a shadow on each surface of the tile
};

// low, high: corners of the atlas region that the tile covers (texels); depths: least and greatest map depth of the
// tile's surfaces; inside: whether the whole tile lies within the map
bool farol_compare(const in vec2 low, const in vec2 high, const in vec2 depths, const in bool inside,
  inout FarolComparison comparison) {
  ivec2 first = ivec2(max(low, 0.0)) >> 3;
  ivec2 last = ivec2(high) >> 3;
  if (max(last.x - first.x, last.y - first.y) >= FAROL_MOST_BLOCKS) return false;
  uvec2 bounds = uvec2(65535u, 0u);
  // 2 × 2 blocks a step, so that fetches overlap
  for (int y = first.y; y <= last.y; y += 2) {
    for (int x = first.x; x <= last.x; x += 2) {
      ivec2 next = min(ivec2(x, y) + 1, last);
      uvec2 a = texelFetch(farol_shadowBounds, ivec2(x, y), 0).xy;
      uvec2 b = texelFetch(farol_shadowBounds, ivec2(next.x, y), 0).xy;
      uvec2 c = texelFetch(farol_shadowBounds, ivec2(x, next.y), 0).xy;
      uvec2 d = texelFetch(farol_shadowBounds, next, 0).xy;
      bounds = uvec2(min(min(bounds.x, min(a.x, b.x)), min(c.x, d.x)),
        max(max(bounds.y, max(a.y, b.y)), max(c.y, d.y)));
    }
  }
  vec2 map = vec2(bounds);
  vec2 surface = depths * 65535.0;
  bool reversed = farol_depthMode.x > 0.0;
  comparison.isLit = comparison.isLit && (reversed ? surface.x - 2.0 >= map.y : surface.y + 2.0 <= map.x);
  comparison.isDark = comparison.isDark && inside && (reversed ? surface.y + 2.0 < map.x : surface.x - 2.0 > map.y);
  return comparison.isLit || comparison.isDark;
}

#ifdef FAROL_SHADOW_CUBES
// compares a tile with a cube map if one face contains the whole tile, as is usual; samples outside of the face stay
// within its border
bool farol_compareCube(const in int record, const in FarolMask mask, inout FarolComparison comparison) {
  vec3 centre = farol_worldAxes * farol_maskPosition(record);
  float bias = abs(mask.normalBias);
  int face = int(farol_cubeFace(0.5 * (farol_worldCorners[0] + farol_worldCorners[7]) - centre).z);
  // corners relative to a cube's face: across, up and along its axis
  bool isX = face < 2;
  bool isY = face == 2 || face == 3;
  float side = (face & 1) == 0 ? 1.0 : -1.0;
  vec3 signs = vec3(isX || isY ? side : -side, 1.0, side);
  vec4 part = vec4(1e30, 1e30, -1e30, -1e30);
  vec2 away = vec2(1e30, -1e30);
  for (int i = 0; i < 8; i++) {
    vec3 there = farol_worldCorners[i] - centre;
    there = signs * (isX ? there.zyx : isY ? there.xzy : there);
    vec2 at = there.xy / there.z;
    part = vec4(min(part.xy, at), max(part.zw, at));
    away = vec2(min(away.x, there.z), max(away.y, there.z));
  }
  away += vec2(-bias, bias);
  if (away.x < 1e-4) return false;
  float shift = bias * (1.0 + max(max(abs(part.x), abs(part.y)), max(abs(part.z), abs(part.w)))) / away.x;
  part += vec4(-shift, -shift, shift, shift);
  if (min(part.x, part.y) < -0.9999 || max(part.z, part.w) > 0.9999) return false;
  vec2 terms = mask.filtering.y / away;
  // change of depth across the disk, since its samples differ in distance along the axis
  float slant = 1.7320508 * abs(mask.filtering.z) * max(abs(terms.x), abs(terms.y));
  terms = mask.filtering.x + vec2(min(terms.x, terms.y), max(terms.x, terms.y));
  int row = face / 3;
  vec2 corner = mask.region.xy + vec2(face - 3 * row, row) * (mask.region.z + 2.0 * mask.border);
  return farol_compare(corner + (part.xy * 0.5 + 0.5) * mask.region.z - 1.0,
    corner + (part.zw * 0.5 + 0.5) * mask.region.z + 2.0 * mask.border + 1.0,
    terms + vec2(-slant, slant), terms.x >= 0.0 && terms.y <= 1.0, comparison);
}

#endif

#ifdef FAROL_SHADOW_MAPS
// compares a tile with a map other than a cube
bool farol_compareMap(const in int record, const in FarolMask mask, inout FarolComparison comparison) {
  mat4 matrix = farol_maskMatrix(record);
  mat4 rows = transpose(matrix);
  vec4 shift = abs(mask.normalBias) * vec4(length(rows[0].xyz), length(rows[1].xyz), length(rows[2].xyz),
    length(rows[3].xyz));
  vec3 low = vec3(1e30);
  vec3 high = vec3(-1e30);
  for (int i = 0; i < 8; i++) {
    vec4 there = matrix * vec4(farol_corners[i], 1.0);
    if (there.w - shift.w < 1e-4) return false;
    vec2 u = farol_ratio(there.x, shift.x, there.w, shift.w);
    vec2 v = farol_ratio(there.y, shift.y, there.w, shift.w);
    vec2 depth = farol_ratio(there.z, shift.z, there.w, shift.w);
    low = min(low, vec3(u.x, v.x, depth.x));
    high = max(high, vec3(u.y, v.y, depth.y));
  }
  vec2 depths = vec2(low.z, high.z) + mask.filtering.x;
  vec2 reach = abs(mask.filtering.yz) * mask.region.z + 1.5;
  return farol_compare(mask.region.xy + clamp(low.xy * mask.region.z - reach, 0.0, mask.region.z - 1.0),
    mask.region.xy + clamp(high.xy * mask.region.z + reach, 0.0, mask.region.z - 1.0), depths,
    min(low.x, low.y) >= 0.0 && max(high.x, high.y) <= 1.0 && depths.y <= 1.0, comparison);
}
#endif

// 1: the light's shadow map leaves all of the tile lit; 2: none of it; 0: neither, or unknown
int farol_tileShadow(const in int record) {
  FarolMask mask = farol_readMask(record);
  if (!farol_maskHasBounds(record) || mask.isExtended) return 0;
  FarolComparison comparison = FarolComparison(true, true);
  bool isCube = farol_looksUpCube(mask);
#ifdef FAROL_SHADOW_CUBES
  if (isCube && !farol_compareCube(record, mask, comparison)) return 0;
#endif
#ifdef FAROL_SHADOW_MAPS
  if (!isCube && !farol_compareMap(record, mask, comparison)) return 0;
#endif
  // skips lights with an image, a profile or layers
#ifdef FAROL_LIGHT_PROFILES
  if (comparison.isLit && mask.hasProfile) return 0;
#endif
  if (comparison.isLit) return mask.cookie == FAROL_COOKIE_NONE && farol_maskLayers(record) == vec2(0.0) ? 1 : 0;
  return mask.filtering.w == 1.0 ? 2 : 0;
}
//# main
int pairs = farol_tileShadowWords >> 1;
ivec2 at = ivec2(gl_FragCoord.xy);
ivec2 tile = ivec2(at.x / pairs, at.y);
int word = 2 * (at.x % pairs);
uvec4 marks = uvec4(0u);
if (farol_findCorners(tile)) {
  vec3 low = farol_corners[0];
  vec3 high = low;
  for (int i = 1; i < 8; i++) {
    low = min(low, farol_corners[i]);
    high = max(high, farol_corners[i]);
  }
  ivec2 cell = (tile * FAROL_TILE) >> farol_grid.x;
  uvec4 quad = texelFetch(farol_gridMasks, ivec2(cell.x, (word >> 2) * farol_grid.y + cell.y), 0);
  uvec2 words = (word & 2) == 0 ? quad.xy : quad.zw;
  for (int half2 = 0; half2 < 2; half2++) {
    for (uint bits = half2 == 0 ? words.x : words.y; bits != 0u; bits &= bits - 1u) {
      int light = farol_grid.w + (word + half2) * 32 + farol_lowestBit(bits);
      if (farol_lightIsPlain(light)) continue;
      vec4 sphere = farol_lightSphere(light);
      vec3 centre = farol_lightPosition(sphere);
      float range = farol_lightRange(sphere);
      vec3 away = max(max(low - centre, centre - high), 0.0);
      vec4 details = farol_lightDetails(light);
      int shadow = dot(away, away) > range * range ? 2
        : farol_lightIsMasked(details) ? farol_tileShadow(farol_lightMaskRecord(details)) : 0;
      // both bits mark three's point lights that light all of the tile, for a shorter path
      if (shadow == 1 && farol_lightIsMaskedPoint(details)) shadow = 3;
      uvec2 mark = (bits & (~bits + 1u)) * uvec2(shadow & 1, shadow >> 1);
      if (half2 == 0) marks.xy |= mark; else marks.zw |= mark;
    }
  }
}
farol_marks = marks;
