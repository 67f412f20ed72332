// Mean of a texel's samples, with the variance of its luminance or, with SOURCES, the luminance of sky and emissive
// surfaces; -1 for a texel without a surface
// Welford 1962
#include "sampleCount"
uniform highp sampler2D farol_positions;
uniform highp sampler2D farol_sums;
uniform highp sampler2D farol_sourceSums;
uniform float farol_scale; // factor that turns the sum into the mean
layout(location = 0) out highp vec4 farol_mean;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  if (texelFetch(farol_positions, texel, 0).w <= 0.0) {
    farol_mean = vec4(0.0, 0.0, 0.0, -1.0);
    return;
  }
  float samples = farol_sampleCount(texel);
  vec4 mean = texelFetch(farol_sums, texel, 0) / samples;
#ifdef SOURCES
  farol_mean = farol_scale * vec4(mean.rgb, texelFetch(farol_sourceSums, texel, 0).r / samples);
#else
  float luminance = dot(mean.rgb, vec3(0.2126, 0.7152, 0.0722));
  float variance = max(mean.a - luminance * luminance, 0.0) / max(samples - 1.0, 1.0);
  farol_mean = vec4(farol_scale * mean.rgb, farol_scale * farol_scale * variance);
#endif
}
