// Bits of 128 lights that touch one tile: tests a light's range (and cone) against the tile's frustum, and with
// FAROL_DEPTH against the tile's depths: boxes before and behind the largest gap, and slices. FAROL_COARSE: tests all
// lights against blocks of 4 × 4 tiles; tiles then test those that passed.
// Olsson and Assarsson 2011, Tiled Shading; Harada 2012, A 2.5D Culling for Forward+; Wronski 2017, Cull that cone
#include "lightTiles"
#include "lightTable"
#include "unproject"
uniform highp usampler2D farol_coarseMask;
uniform highp usampler2D farol_tileDepth;
uniform vec2 farol_size;
// distance (m) from which on depth cannot be told from an empty pixel's; -1e30: depth gives no distances
uniform highp float farol_beyond;
uniform highp float farol_plainReach; // share of its range within which a plain point light is listed
layout(location = 0) out highp uvec4 farol_mask;

struct FarolTile {
  vec4 slopes; // xy: low sides, zw: high sides of the tile at distance 1 m (orthographic: at any distance)
  vec4 scales; // 1 / length of each side's normal
  vec2 range; // nearest and farthest distance (m)
  // low and high corners of the boxes around the surfaces before and behind the gap (view space, m)
  vec3 low[2];
  vec3 high[2];
  uint slices;
  float beyond; // distance (m) from which on depth may not show surfaces
};

// corners of the box around a tile's frustum between two distances (view space, m)
void farol_boxOf(const in vec4 slopes, const in vec2 range, out vec3 low, out vec3 high) {
  vec2 at = mix(vec2(1.0), range, farol_perspective);
  vec4 nearSides = slopes * at.x;
  vec4 farSides = slopes * at.y;
  low = vec3(min(nearSides.xy, farSides.xy), -range.y);
  high = vec3(max(nearSides.zw, farSides.zw), -range.x);
}

// squared distance of a point from a box (m²)
float farol_outside(const in vec3 position, const in vec3 low, const in vec3 high) {
  vec3 outside = max(max(low - position, position - high), 0.0);
  return dot(outside, outside);
}

FarolTile farol_tileAt(const in ivec2 tile, const in int shift) {
  FarolTile t;
  vec2 low = vec2(tile << shift) / farol_size * 2.0 - 1.0;
  vec2 high = vec2((tile + 1) << shift) / farol_size * 2.0 - 1.0;
  t.slopes = vec4((low + farol_unprojectXY.zw) * farol_unprojectXY.xy,
    (high + farol_unprojectXY.zw) * farol_unprojectXY.xy);
  t.scales = inversesqrt(1.0 + farol_perspective * t.slopes * t.slopes);
  t.range = vec2(-1e30, 1e30);
  t.slices = 4294967295u;
  t.beyond = 1e38;
#ifdef FAROL_DEPTH
  uvec4 depths = texelFetch(farol_tileDepth, tile, 0);
  // widened by the rounding of positions
  t.range = uintBitsToFloat(depths.xy) * vec2(0.9999, 1.0001);
  vec2 ends = uintBitsToFloat(depths.xy);
  vec2 gap = ends.x + farol_unpackGap(depths.w) * (ends.y - ends.x);
  gap += vec2(0.0001, -0.0001) * abs(gap);
  t.slices = depths.z;
  if ((depths.w & 1u) != 0u || farol_beyond < -1e29) t.beyond = farol_beyond;
  farol_boxOf(t.slopes, vec2(t.range.x, gap.x), t.low[0], t.high[0]);
  farol_boxOf(t.slopes, vec2(gap.y, t.range.y), t.low[1], t.high[1]);
#endif
  return t;
}

bool farol_touches(const in FarolTile tile, const in vec4 sphere, const in int light) {
  float radius = sphere.w * (light < farol_tileRun.w << 7 ? farol_plainReach : 1.0001);
  float k = mix(1.0, -sphere.z, farol_perspective);
  vec4 sides = vec4(sphere.xy - tile.slopes.xy * k, tile.slopes.zw * k - sphere.xy) * tile.scales;
  if (min(min(sides.x, sides.y), min(sides.z, sides.w)) < -radius) return false;
#ifdef FAROL_DEPTH
  if (radius - sphere.z >= tile.beyond) return true;
  if (tile.range.x > tile.range.y) return false;
  if (min(farol_outside(sphere.xyz, tile.low[0], tile.high[0]), farol_outside(sphere.xyz, tile.low[1], tile.high[1]))
    > radius * radius) return false;
#if FAROL_DEPTH > 1
  vec2 slices = (vec2(-sphere.z - radius, -sphere.z + radius) - tile.range.x)
    * (32.0 / max(tile.range.y - tile.range.x, 1e-6));
  int first = int(clamp(slices.x, 0.0, 31.0));
  int last = int(clamp(slices.y, 0.0, 31.0));
  if ((tile.slices & farol_bitsFrom(0, max(first - 1, 0), min(last + 1, 31))) == 0u) return false;
#endif
  // tests a cone against the sphere around both boxes; plain point lights have no cone
  if (light >= farol_tileRun.w << 7 && !farol_lightIsPlain(farol_tileRun.x + light)) {
    vec4 cone = farol_lightCone(farol_tileRun.x + light);
    if (farol_lightIsCone(cone)) {
      float cutoff = farol_lightCutoff(cone);
      vec3 low = min(tile.low[0], tile.low[1]);
      vec3 high = max(tile.high[0], tile.high[1]);
      vec3 towards = 0.5 * (low + high) - sphere.xyz;
      float around = 0.5 * length(high - low) * 1.0001;
      float along = -dot(towards, farol_lightAxis(cone));
      float across = sqrt(max(dot(towards, towards) - along * along, 0.0));
      if (cutoff * across - along * sqrt(1.0 - cutoff * cutoff) > around || along < -around) return false;
    }
  }
#endif
  return true;
}

uint farol_touching(const in FarolTile tile, const in uint candidates, const in int start) {
  uint touching = 0u;
  for (uint bits = candidates; bits != 0u; bits &= bits - 1u) {
    int bit = farol_lowestBit(bits);
    // two lights in each step, so that their texture reads overlap
    bits &= bits - 1u;
    int other = bits == 0u ? bit : farol_lowestBit(bits);
    vec4 sphere = farol_lightSphere(farol_tileRun.x + start + bit);
    vec4 otherSphere = farol_lightSphere(farol_tileRun.x + start + other);
    if (farol_touches(tile, sphere, start + bit)) touching |= 1u << uint(bit);
    if (farol_touches(tile, otherSphere, start + other)) touching |= 1u << uint(other);
  }
  return touching;
}
//# main
ivec2 grid = farol_tiles.yz;
int shift = FAROL_TILE_SHIFT;
#ifdef FAROL_COARSE
grid = (grid + 3) >> 2;
shift += 2;
#endif
ivec2 at = ivec2(gl_FragCoord.xy);
ivec2 place = at / grid;
ivec2 position = at - place * grid;
int quad = place.x + (place.y << farol_tiles.x);
int start = quad * 128;
farol_mask = uvec4(0u);
if (quad < farol_tiles.w) {
#ifdef FAROL_COARSE
  int last = farol_tileRun.y - 1;
  uvec4 candidates = uvec4(farol_bitsFrom(start, 0, last), farol_bitsFrom(start + 32, 0, last),
    farol_bitsFrom(start + 64, 0, last), farol_bitsFrom(start + 96, 0, last));
#else
  uvec4 candidates = texelFetch(farol_coarseMask, farol_listTexel(position >> 2, (grid + 3) >> 2, quad), 0);
#endif
  if (candidates != uvec4(0u)) {
    FarolTile tile = farol_tileAt(position, shift);
    if (tile.range.x <= tile.range.y || tile.beyond < 1e37) {
      farol_mask = uvec4(farol_touching(tile, candidates.x, start), farol_touching(tile, candidates.y, start + 32),
        farol_touching(tile, candidates.z, start + 64), farol_touching(tile, candidates.w, start + 96));
    }
  }
}
