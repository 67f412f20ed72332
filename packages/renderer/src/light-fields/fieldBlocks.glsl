// Bits of the lights, among 128, that touch a block of 4 × 4 tiles: tests boxes of 32 lights, then the lights in
// boxes that touch the block; with FAROL_BLOCK_DEPTH also against the block's depths.
// Farol; Olsson and Assarsson 2011, Tiled Shading
#include "tileMask"
uniform highp sampler2D farol_boxLows;
uniform highp sampler2D farol_boxHighs;
uniform highp usampler2D farol_fieldTileDepth;

// nearest and farthest distance (m) of surfaces in a block
vec2 farol_blockRange(const in ivec2 block) {
  vec2 range = vec2(1e30, -1e30);
  ivec2 last = min(block * 4 + 4, farol_tiles.yz);
  for (int y = block.y * 4; y < last.y; y++) {
    for (int x = block.x * 4; x < last.x; x++) {
      uvec4 depths = texelFetch(farol_fieldTileDepth, ivec2(x, y), 0);
      vec2 tile = uintBitsToFloat(depths.xy) * vec2(0.9999, 1.0001);
      if (tile.x <= tile.y) range = vec2(min(range.x, tile.x), max(range.y, tile.y));
      if ((depths.w & 1u) != 0u || farol_beyond < -1e29) {
        range = vec2(min(range.x, farol_beyond), max(range.y, 1e30));
      }
    }
  }
  return range;
}

// below 0 if a box is outside of one of the four sides of a block
float farol_insideSides(const in FarolTile tile, const in vec4 low, const in vec3 high) {
  vec2 k = mix(vec2(1.0), vec2(-low.w, -low.z), farol_perspective);
  vec4 nearK = tile.slopes * k.x;
  vec4 farK = tile.slopes * k.y;
  vec4 sides = vec4(high.xy - min(nearK.xy, farK.xy), max(nearK.zw, farK.zw) - low.xy);
  return min(min(sides.x, sides.y), min(sides.z, sides.w));
}

bool farol_reaches(const in FarolTile tile, const in vec2 range, const in vec4 sphere) {
  float radius = sphere.w * 1.0001;
  return radius - sphere.z >= range.x && -radius - sphere.z <= range.y && farol_touches(tile, sphere, 0);
}

uint farol_inBlock(const in FarolTile tile, const in vec2 range, const in int start) {
  uint touching = 0u;
  int end = min(32, farol_tileRun.y - start);
  // two lights in each step, so that their texture reads overlap
  for (int i = 0; i < end; i += 2) {
    int other = min(i + 1, end - 1);
    vec4 sphere = farol_lightSphere(farol_tileRun.x + start + i);
    vec4 otherSphere = farol_lightSphere(farol_tileRun.x + start + other);
    if (farol_reaches(tile, range, sphere)) touching |= 1u << uint(i);
    if (farol_reaches(tile, range, otherSphere)) touching |= 1u << uint(other);
  }
  return touching;
}
//# main
ivec2 grid = (farol_tiles.yz + 3) >> 2;
ivec2 at = ivec2(gl_FragCoord.xy);
ivec2 place = at / grid;
ivec2 block = at - place * grid;
int quad = place.x + (place.y << farol_tiles.x);
farol_mask = uvec4(0u);
if (quad < farol_tiles.w) {
  FarolTile tile = farol_tileAt(block, FAROL_TILE_SHIFT + 2);
  vec4 lows[4];
  bool inside[4];
  bool any = false;
  for (int i = 0; i < 4; i++) {
    lows[i] = texelFetch(farol_boxLows, ivec2(i, quad), 0);
    inside[i] = lows[i].x < 1e29
      && farol_insideSides(tile, lows[i], texelFetch(farol_boxHighs, ivec2(i, quad), 0).xyz) >= 0.0;
    any = any || inside[i];
  }
  if (any) {
#ifdef FAROL_BLOCK_DEPTH
    vec2 range = farol_blockRange(block);
#else
    vec2 range = vec2(-1e30, 1e30);
#endif
    uvec4 touching = uvec4(0u);
    for (int i = 0; i < 4; i++) {
      if (inside[i] && -lows[i].z >= range.x && -lows[i].w <= range.y)
        touching[i] = farol_inBlock(tile, range, quad * 128 + i * 32);
    }
    farol_mask = touching;
  }
}
