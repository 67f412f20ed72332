// 1 where the first samples of a texel and its neighbours are all equal, so that more samples would not change them
// Mitchell 1987, Generating Antialiased Images at Low Sampling Densities
uniform highp sampler2D farol_positions;
uniform highp sampler2D farol_sums;
uniform float farol_samples; // number of samples in the sums
layout(location = 0) out highp vec4 farol_agreed;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(farol_sums, 0) - 1;
  farol_agreed = vec4(1.0);
  for (int y = -2; y <= 2; y++)
    for (int x = -2; x <= 2; x++) {
      ivec2 at = clamp(texel + ivec2(x, y), ivec2(0), last);
      if (texelFetch(farol_positions, at, 0).w <= 0.0) continue;
      vec4 mean = texelFetch(farol_sums, at, 0) / farol_samples;
      float luminance = dot(mean.rgb, vec3(0.2126, 0.7152, 0.0722));
      if (mean.a - luminance * luminance > 1e-4 * mean.a) farol_agreed = vec4(0.0);
    }
}
