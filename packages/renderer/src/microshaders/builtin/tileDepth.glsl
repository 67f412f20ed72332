// Nearest and farthest distance of the surfaces in each tile, and which of 32 slices between them hold any.
// Harada 2012, A 2.5D Culling for Forward+
#include "lightTiles"
#include "unproject"
uniform highp usampler2D farol_blocks;
uniform vec2 farol_size;
layout(location = 0) out highp uvec4 farol_tileDepthOut; // bits of nearest and farthest (m), slices

// depth: as the blocks have it
float farol_viewDistance(const in float depth) {
  return -farol_viewZ(farol_depthMode.x > 0.0 ? -depth : depth);
}
//# main
ivec2 first = ivec2(gl_FragCoord.xy) << (farol_tiles.x - 2);
ivec2 last = min(first + (1 << (farol_tiles.x - 2)), (ivec2(farol_size) + 3) >> 2);
float nearest = 2.0;
float farthest = -2.0;
for (int y = first.y; y < last.y; y++) {
  for (int x = first.x; x < last.x; x++) {
    vec2 block = uintBitsToFloat(texelFetch(farol_blocks, ivec2(x, y), 0).xy);
    nearest = min(nearest, block.x);
    farthest = max(farthest, block.y);
  }
}
if (farthest < -1.5) {
  farol_tileDepthOut = uvec4(floatBitsToUint(1.0), floatBitsToUint(-1.0), 0u, 0u);
} else {
  float from = farol_viewDistance(nearest);
  float to = farol_viewDistance(farthest);
  uint slices = 0u;
  float scale = 32.0 / max(to - from, 1e-6);
  for (int y = first.y; y < last.y; y++) {
    for (int x = first.x; x < last.x; x++) {
      vec2 block = uintBitsToFloat(texelFetch(farol_blocks, ivec2(x, y), 0).xy);
      if (block.y >= -1.5) {
        int low = int(clamp((farol_viewDistance(block.x) - from) * scale, 0.0, 31.0));
        int high = int(clamp((farol_viewDistance(block.y) - from) * scale, 0.0, 31.0));
        slices |= farol_bitsFrom(0, low, high);
      }
    }
  }
  farol_tileDepthOut = uvec4(floatBitsToUint(from), floatBitsToUint(to), slices, 0u);
}
