// Nearest and farthest depth in each block of 4 × 4 pixels, the first step to the depths of a tile.
// Farol
#include "depthMode"
uniform highp sampler2D farol_sceneDepth;
uniform vec2 farol_size;
// bits of nearest and farthest depth, reversed depth negative; farthest -2 where nothing is; 1 where a pixel is empty
layout(location = 0) out highp uvec4 farol_block;
//# main
ivec2 first = ivec2(gl_FragCoord.xy) * 4;
ivec2 last = min(first + 4, ivec2(farol_size));
float nearest = 2.0;
float farthest = -2.0;
uint empty = 0u;
for (int y = first.y; y < last.y; y++) {
  for (int x = first.x; x < last.x; x++) {
    float depth = texelFetch(farol_sceneDepth, ivec2(x, y), 0).r;
    if (!farol_isEmpty(depth)) {
      if (farol_depthMode.x > 0.0) depth = -depth;
      nearest = min(nearest, depth);
      farthest = max(farthest, depth);
    } else {
      empty = 1u;
    }
  }
}
farol_block = uvec4(floatBitsToUint(nearest), floatBitsToUint(farthest), empty, 0u);
