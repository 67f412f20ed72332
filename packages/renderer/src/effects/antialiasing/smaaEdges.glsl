// SMAA, first step: edges of luma, without those that a stronger one beside them masks. r: to the left pixel, g: to the
// one below.
// Jimenez et al. 2012, SMAA: Enhanced Subpixel Morphological Antialiasing, 3.1 and 4.1; https://www.iryoku.com/smaa/
#include "displayTransfer"
uniform highp sampler2D farol_picture;
uniform bool farol_encoded;
layout(location = 0) out highp vec4 farol_edges;

float farol_lumaAt(const in ivec2 pixel) {
  vec3 color = texelFetch(farol_picture, clamp(pixel, ivec2(0), textureSize(farol_picture, 0) - 1), 0).rgb;
  if (!farol_encoded) color = farol_toDisplay(clamp(color, 0.0, 1.0));
  return dot(color, vec3(0.2126, 0.7152, 0.0722));
}
//# main
const float THRESHOLD = 0.05;
ivec2 pixel = ivec2(gl_FragCoord.xy);
float luma = farol_lumaAt(pixel);
float left = farol_lumaAt(pixel + ivec2(-1, 0));
float below = farol_lumaAt(pixel + ivec2(0, -1));
vec2 delta = abs(luma - vec2(left, below));
vec2 edges = step(THRESHOLD, delta);
if (edges.x + edges.y == 0.0) discard;
vec2 others = abs(luma - vec2(farol_lumaAt(pixel + ivec2(1, 0)), farol_lumaAt(pixel + ivec2(0, 1))));
vec2 beyond = abs(vec2(left, below) - vec2(farol_lumaAt(pixel + ivec2(-2, 0)), farol_lumaAt(pixel + ivec2(0, -2))));
vec2 largest = max(max(delta, others), beyond);
edges *= step(max(largest.x, largest.y), 2.0 * delta);
farol_edges = vec4(edges, 0.0, 1.0);
