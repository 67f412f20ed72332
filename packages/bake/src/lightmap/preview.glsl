// Light so far: the finished stages, and the mean of the present stage's samples
// three.js
#include "sampleCount"
uniform highp sampler2D farol_light;
uniform highp sampler2D farol_sums;
uniform highp sampler2D farol_positions;
uniform float farol_scale;
layout(location = 0) out highp vec4 farol_preview;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  bool isValid = texelFetch(farol_positions, texel, 0).w > 0.0;
  vec3 mean = texelFetch(farol_sums, texel, 0).rgb / farol_sampleCount(texel);
  vec3 light = texelFetch(farol_light, texel, 0).rgb + farol_scale * mean;
  farol_preview = isValid ? vec4(light, 0.0) : vec4(0.0, 0.0, 0.0, -1.0);
}
