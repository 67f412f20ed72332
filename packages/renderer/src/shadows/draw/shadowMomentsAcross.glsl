// Mean and standard deviation of a shadow map's depths from those of shadowMomentsDown.glsl, blurred along its rows.
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
  vec2 texel = clamp(at + vec2(offset, 0.0), vec2(0.5), last);
  vec2 moments = textureLod(farol_momentSource, texel / vec2(textureSize(farol_momentSource, 0)), 0.0).rg;
  mean += moments.x;
  squaredMean += moments.y * moments.y + moments.x * moments.x;
}
mean /= samples;
squaredMean /= samples;
farol_moments = vec4(mean, sqrt(max(0.0, squaredMean - mean * mean)), 0.0, 1.0);
