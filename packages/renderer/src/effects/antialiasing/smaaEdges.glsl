// SMAA, first step: edges of luma and of alpha, without those next to a much stronger edge.
// r: to the left pixel, g: to the one below.
// Jimenez et al. 2012, SMAA: Enhanced Subpixel Morphological Antialiasing, 3.1 and 4.1; https://www.iryoku.com/smaa/
#include "displayTransfer"
#include "frameSize"
uniform highp sampler2D farol_picture;
uniform bool farol_encoded;
layout(location = 0) out highp vec4 farol_edges;

// luma and alpha of a pixel
vec2 farol_lumaAt(const in ivec2 pixel) {
  vec4 color = texelFetch(farol_picture, clamp(pixel, ivec2(0), ivec2(farol_frameSize) - 1), 0);
  if (!farol_encoded) color = farol_toDisplay(clamp(color, 0.0, 1.0));
  return vec2(dot(color.rgb, vec3(0.2126, 0.7152, 0.0722)), clamp(color.a, 0.0, 1.0));
}

float farol_apart(const in vec2 a, const in vec2 b) {
  vec2 off = abs(a - b);
  return max(off.x, off.y);
}
//# main
const float THRESHOLD = 0.05;
ivec2 pixel = ivec2(gl_FragCoord.xy);
vec2 luma = farol_lumaAt(pixel);
vec2 left = farol_lumaAt(pixel + ivec2(-1, 0));
vec2 below = farol_lumaAt(pixel + ivec2(0, -1));
vec2 delta = vec2(farol_apart(luma, left), farol_apart(luma, below));
vec2 edges = step(THRESHOLD, delta);
if (edges.x + edges.y == 0.0) discard;
float right = farol_apart(luma, farol_lumaAt(pixel + ivec2(1, 0)));
float above = farol_apart(luma, farol_lumaAt(pixel + ivec2(0, 1)));
float farLeft = farol_apart(left, farol_lumaAt(pixel + ivec2(-2, 0)));
float farBelow = farol_apart(below, farol_lumaAt(pixel + ivec2(0, -2)));
float largest = max(max(max(delta.x, delta.y), max(right, above)), max(farLeft, farBelow));
edges *= step(largest, 2.0 * delta);
farol_edges = vec4(edges, 0.0, 1.0);
