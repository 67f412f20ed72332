// Nearest and farthest depth in each block of 4 × 4 pixels and the gap between them; tileDepth.glsl reads them.
// Farol
#include "depthMode"
uniform highp sampler2D farol_sceneDepth;
uniform vec2 farol_size;
// x, y: float bits of nearest and farthest depth, negated if reversed, farthest -2 in an empty block; z: 1 if a pixel
// is empty; w: gap without pixels, start (low 16 bits) and end (high), in 65,535ths between nearest and farthest
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
// no gap: starts at the end, ends at the start
uint gap = 65535u;
// a block across an edge has a gap between the farthest pixel of its near half and the nearest of its far half;
// blocks whose depth range is within a fiftieth of their distance (perspective) are not searched
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
  // the gap is stored one step narrower, so that rounding never widens it
  vec2 parts = (ends - nearest) * (65535.0 / max(farthest - nearest, 1e-30));
  uvec2 narrowed = uvec2(clamp(vec2(ceil(parts.x) + 1.0, floor(parts.y) - 1.0), 0.0, 65535.0));
  gap = narrowed.x | narrowed.y << 16;
}
farol_block = uvec4(floatBitsToUint(nearest), floatBitsToUint(farthest), empty, gap);
