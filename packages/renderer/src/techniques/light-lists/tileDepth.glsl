// Nearest and farthest distance in each tile, bits of the occupied ones of 32 slices between, and the largest gap.
// Harada 2012, A 2.5D Culling for Forward+
#include "lightTiles"
#include "unproject"
uniform highp usampler2D farol_blocks;
uniform vec2 farol_size;
// x, y: float bits of nearest and farthest distance (m); z: slice bits; w: bit 0 if a pixel is empty, and
// farol_packGap
layout(location = 0) out highp uvec4 farol_tileDepthOut;

// distance (m) of a depth from farol_blocks, negative if reversed; steps: rounding steps added to the depth
float farol_viewDistance(const in float depth, const in float steps) {
  if (farol_depthMode.x > 0.0) return -farol_viewZ(-depth);
  float distanceVS = -farol_viewZ(farol_depthMode.y > 0.0 ? depth : min(depth + steps * 6e-8, 1.0));
  // 1e15: too far for the precision of depth
  return distanceVS < 1e15 && (distanceVS > 0.0 || farol_perspective == 0.0) ? distanceVS : 1e15;
}

// distances (m) of a block's surfaces before (x to y) and behind (z to w) its gap
vec4 farol_blockRuns(const in uvec4 block) {
  vec2 depths = uintBitsToFloat(block.xy);
  float to = farol_viewDistance(depths.y, 4.0);
  if (block.w == 65535u) return vec4(farol_viewDistance(depths.x, -4.0), to, to, to);
  vec2 gap = depths.x + vec2(block.w & 65535u, block.w >> 16) * ((depths.y - depths.x) / 65535.0);
  return vec4(farol_viewDistance(depths.x, -4.0), farol_viewDistance(gap.x, 4.0), farol_viewDistance(gap.y, -4.0), to);
}
//# main
ivec2 first = ivec2(gl_FragCoord.xy) << (FAROL_TILE_SHIFT - 2);
ivec2 last = min(first + (1 << (FAROL_TILE_SHIFT - 2)), (ivec2(farol_size) + 3) >> 2);
float nearest = 2.0;
float farthest = -2.0;
uint empty = 0u;
for (int y = first.y; y < last.y; y++) {
  for (int x = first.x; x < last.x; x++) {
    uvec4 words = texelFetch(farol_blocks, ivec2(x, y), 0);
    vec2 block = uintBitsToFloat(words.xy);
    empty |= words.z;
    nearest = min(nearest, block.x);
    farthest = max(farthest, block.y);
  }
}
if (farthest < -1.5) {
  farol_tileDepthOut = uvec4(floatBitsToUint(1.0), floatBitsToUint(-1.0), 0u, empty);
} else {
  float from = farol_viewDistance(nearest, -4.0);
  float to = farol_viewDistance(farthest, 4.0);
  uint slices = 0u;
  float scale = 32.0 / max(to - from, 1e-6);
  for (int y = first.y; y < last.y; y++) {
    for (int x = first.x; x < last.x; x++) {
      uvec4 block = texelFetch(farol_blocks, ivec2(x, y), 0);
      if (uintBitsToFloat(block.y) >= -1.5) {
        ivec4 ends = ivec4(clamp((farol_blockRuns(block) - from) * scale, 0.0, 31.0));
        slices |= farol_bitsFrom(0, ends.x, ends.y) | farol_bitsFrom(0, ends.z, ends.w);
      }
    }
  }
  // length of the longest run of empty slices: shortens all runs by one until none is left
  uint left = 0u;
  float count = 0.0;
  for (uint holes = ~slices; holes != 0u; holes &= holes << 1) {
    left = holes;
    count += 1.0;
  }
  vec2 gap = vec2(to);
  if (count > 0.0) {
    float middle = from + (float(farol_lowestBit(left)) + 1.0 - 0.5 * count) / scale;
    gap.x = from;
    for (int y = first.y; y < last.y; y++) {
      for (int x = first.x; x < last.x; x++) {
        uvec4 block = texelFetch(farol_blocks, ivec2(x, y), 0);
        if (uintBitsToFloat(block.y) >= -1.5) {
          vec4 runs = farol_blockRuns(block);
          if (runs.x <= middle) gap.x = max(gap.x, runs.w <= middle ? runs.w : runs.y);
          if (runs.w > middle) gap.y = min(gap.y, runs.x > middle ? runs.x : runs.z);
        }
      }
    }
  }
  farol_tileDepthOut = uvec4(floatBitsToUint(from), floatBitsToUint(to), slices,
    empty | farol_packGap((gap - from) * (1.0 / max(to - from, 1e-6))));
}
