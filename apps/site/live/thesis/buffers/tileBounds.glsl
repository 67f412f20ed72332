// Nearest and farthest distance of the surfaces in a tile of 16 × 16 pixels (m); 0 for a tile without a surface.
// Harada 2012, A 2.5D Culling for Forward+; thesis 2.2.3.3.5
#include "unproject"
uniform highp sampler2D thesis_sceneDepth;
layout(location = 0) out highp vec4 thesis_bounds;
//# main
ivec2 size = textureSize(thesis_sceneDepth, 0);
ivec2 first = ivec2(gl_FragCoord.xy) * 16;
vec2 bounds = vec2(1e9, 0.0);
for (int y = 0; y < 16; y++) for (int x = 0; x < 16; x++) {
  ivec2 pixel = first + ivec2(x, y);
  if (any(greaterThanEqual(pixel, size))) continue;
  float depth = texelFetch(thesis_sceneDepth, pixel, 0).r;
  if (depth >= 1.0) continue;
  float away = -farol_viewZ(depth);
  bounds = vec2(min(bounds.x, away), max(bounds.y, away));
}
thesis_bounds = vec4(bounds.y > 0.0 ? bounds : vec2(0.0), 0.0, 1.0);
