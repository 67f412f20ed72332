// Samples in the sums of a texel: fewer where the first agreed
// Mitchell 1987, Generating Antialiased Images at Low Sampling Densities
uniform highp sampler2D farol_agreements;
uniform float farol_samples;
uniform float farol_agreedSamples; // samples of texels that agree with their neighbours; 0: as many as others

float farol_sampleCount(const in ivec2 texel) {
  if (farol_agreedSamples == 0.0 || texelFetch(farol_agreements, texel, 0).r < 0.5) return farol_samples;
  return farol_agreedSamples;
}
