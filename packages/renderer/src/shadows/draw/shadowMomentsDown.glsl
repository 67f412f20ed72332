// Mean and standard deviation of a shadow map's depths, blurred along its columns. Summed in three.js's order: the
// variance is a small difference of large sums, so other rounding would be visible.
// three.js r187 vsm; Donnelly and Lauritzen 2006, Variance Shadow Maps
uniform highp sampler2D farol_momentSource;
uniform highp vec4 farol_momentRegion; // texels; xy: corner of the region that is drawn; zw: size of the map
uniform highp vec2 farol_momentBlur; // x: blur radius (texels); y: number of samples
layout(location = 0) out highp vec4 farol_moments;
//# main
vec2 at = gl_FragCoord.xy - farol_momentRegion.xy;
vec2 last = farol_momentRegion.zw - 0.5;
float samples = farol_momentBlur.y;
float mean = 0.0;
float squaredMean = 0.0;
for (float i = 0.0; i < samples; i++) {
  float offset = samples <= 1.0 ? 0.0 : (i * 2.0 / (samples - 1.0) - 1.0) * farol_momentBlur.x;
  vec2 texel = clamp(at + vec2(0.0, offset), vec2(0.5), last);
  float depth = texelFetch(farol_momentSource, ivec2(texel), 0).r;
  mean += depth;
  squaredMean += depth * depth;
}
mean /= samples;
squaredMean /= samples;
farol_moments = vec4(mean, sqrt(max(0.0, squaredMean - mean * mean)), 0.0, 1.0);
