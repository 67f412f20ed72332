// Nearest and farthest depth in each block of 4 × 4 pixels and the gap at an edge, the first step to a tile's depths.
// Farol
#include "depthMode"
uniform highp sampler2D farol_sceneDepth;
uniform vec2 farol_size;
// bits of nearest and farthest depth, reversed depth negative; farthest -2 where nothing is; 1 where a pixel is empty;
// between nearest and farthest, as parts of 65,535: where no pixel is, from (low half) and to (high half)
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
// none: from the end to the beginning
uint gap = 65535u;
// a block over an edge has depths at both ends: the farthest of the near half and the nearest of the far half; flat
// blocks, of a fiftieth of their distance in perspective, are not searched
if (farthest - nearest > 0.02 * (farol_depthMode.x > 0.0 ? -farthest : 1.0 - farthest)) {
  float middle = 0.5 * (nearest + farthest);
  vec2 ends = vec2(nearest, farthest);
  for (int y = first.y; y < last.y; y++) {
    for (int x = first.x; x < last.x; x++) {
      float depth = texelFetch(farol_sceneDepth, ivec2(x, y), 0).r;
      if (!farol_isEmpty(depth)) {
        if (farol_depthMode.x > 0.0) depth = -depth;
        if (depth <= middle) ends.x = max(ends.x, depth);
        else ends.y = min(ends.y, depth);
      }
    }
  }
  // the stored gap is at least one step narrower, so that rounding never widens it
  vec2 parts = (ends - nearest) * (65535.0 / max(farthest - nearest, 1e-30));
  uvec2 narrowed = uvec2(clamp(vec2(ceil(parts.x) + 1.0, floor(parts.y) - 1.0), 0.0, 65535.0));
  gap = narrowed.x | narrowed.y << 16;
}
farol_block = uvec4(floatBitsToUint(nearest), floatBitsToUint(farthest), empty, gap);
