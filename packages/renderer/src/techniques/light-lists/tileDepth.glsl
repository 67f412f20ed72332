// Nearest and farthest distance of the surfaces in each tile, and bits of the 32 slices between them that hold any.
// Harada 2012, A 2.5D Culling for Forward+
#include "lightTiles"
#include "unproject"
uniform highp usampler2D farol_blocks;
uniform vec2 farol_size;
// x, y: float bits of nearest and farthest (m); z: slices; w: 1 if a pixel is empty
layout(location = 0) out highp uvec4 farol_tileDepthOut;

// depth: from farol_blocks, negative if reversed; steps: rounding steps added to it
float farol_viewDistance(const in float depth, const in float steps) {
  if (farol_depthMode.x > 0.0) return -farol_viewZ(-depth);
  float distanceVS = -farol_viewZ(farol_depthMode.y > 0.0 ? depth : min(depth + steps * 6e-8, 1.0));
  // 1e15: too far for depth to tell
  return distanceVS < 1e15 && (distanceVS > 0.0 || farol_perspective == 0.0) ? distanceVS : 1e15;
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
      vec2 block = uintBitsToFloat(texelFetch(farol_blocks, ivec2(x, y), 0).xy);
      if (block.y >= -1.5) {
        int low = int(clamp((farol_viewDistance(block.x, -4.0) - from) * scale, 0.0, 31.0));
        int high = int(clamp((farol_viewDistance(block.y, 4.0) - from) * scale, 0.0, 31.0));
        slices |= farol_bitsFrom(0, low, high);
      }
    }
  }
  farol_tileDepthOut = uvec4(floatBitsToUint(from), floatBitsToUint(to), slices, empty);
}
