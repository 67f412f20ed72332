// SMAA, third step: blends each pixel with its neighbours across edges by their weights, in linear light.
// Jimenez et al. 2012, SMAA, 3.3
#include "displayTransfer"
#include "frameSize"
uniform highp sampler2D farol_picture;
uniform highp sampler2D farol_weightMap;
uniform bool farol_encoded;
layout(location = 0) out highp vec4 farol_color;

vec4 farol_linearAt(const in ivec2 pixel) {
  vec4 color = texelFetch(farol_picture, clamp(pixel, ivec2(0), ivec2(farol_frameSize) - 1), 0);
  return farol_encoded ? farol_toLinear(color) : color;
}

vec4 farol_weightsAt(const in ivec2 pixel) {
  return any(greaterThanEqual(pixel, ivec2(farol_frameSize))) ? vec4(0.0)
    : texelFetch(farol_weightMap, pixel, 0);
}
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy);
vec4 own = farol_weightsAt(pixel);
// blending weights of the neighbours below, above, left and right
vec4 weights = vec4(own.r, farol_weightsAt(pixel + ivec2(0, 1)).g, own.b, farol_weightsAt(pixel + ivec2(1, 0)).a);
farol_color = farol_linearAt(pixel);
// blends across horizontal or vertical edges only, those of larger weight: blending across all would blur corners
if (max(weights.z, weights.w) > max(weights.x, weights.y)) weights.xy = vec2(0.0);
else weights.zw = vec2(0.0);
float sum = weights.x + weights.y + weights.z + weights.w;
if (sum > 0.0) {
  vec4 blended = farol_color * (1.0 - min(sum, 1.0));
  float scale = sum > 1.0 ? 1.0 / sum : 1.0;
  if (weights.x > 0.0) blended += weights.x * scale * farol_linearAt(pixel + ivec2(0, -1));
  if (weights.y > 0.0) blended += weights.y * scale * farol_linearAt(pixel + ivec2(0, 1));
  if (weights.z > 0.0) blended += weights.z * scale * farol_linearAt(pixel + ivec2(-1, 0));
  if (weights.w > 0.0) blended += weights.w * scale * farol_linearAt(pixel + ivec2(1, 0));
  farol_color = blended;
}
