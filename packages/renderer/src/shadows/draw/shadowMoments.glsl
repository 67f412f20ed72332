// Mean and standard deviation of a shadow map's depths, blurred along its columns; then, as moments, along its rows.
// three.js r187 vsm; Donnelly and Lauritzen 2006, Variance Shadow Maps
uniform highp sampler2D farol_momentSource;
uniform highp vec4 farol_momentRegion; // texels; xy: corner of the region that is drawn; zw: size of the map
uniform highp vec3 farol_momentBlur; // x, y: blur radius along rows, columns (texels); z: number of samples
layout(location = 0) out highp vec4 farol_moments;
//# main
vec2 at = gl_FragCoord.xy - farol_momentRegion.xy;
vec2 last = farol_momentRegion.zw - 0.5;
vec2 size = vec2(textureSize(farol_momentSource, 0));
float samples = farol_momentBlur.z;
float mean = 0.0;
float squaredMean = 0.0;
for (float i = 0.0; i < samples; i++) {
  vec2 offset = samples <= 1.0 ? vec2(0.0) : (i * 2.0 / (samples - 1.0) - 1.0) * farol_momentBlur.xy;
  vec2 texel = clamp(at + offset, vec2(0.5), last);
  // depths are not filtered, and have no deviation
  vec2 moments = farol_momentBlur.y > 0.0
    ? vec2(texelFetch(farol_momentSource, ivec2(texel), 0).r, 0.0)
    : textureLod(farol_momentSource, texel / size, 0.0).rg;
  mean += moments.x;
  squaredMean += dot(moments, moments);
}
mean /= samples;
squaredMean /= samples;
farol_moments = vec4(mean, sqrt(max(0.0, squaredMean - mean * mean)), 0.0, 1.0);
