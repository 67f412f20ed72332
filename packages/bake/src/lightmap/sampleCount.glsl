// Number of samples in the sums of a texel: fewer where the first samples were equal
// Mitchell 1987, Generating Antialiased Images at Low Sampling Densities
uniform highp sampler2D farol_agreements;
uniform float farol_samples;
uniform float farol_agreedSamples; // samples of texels whose first samples were equal; 0: as many as other texels

float farol_sampleCount(const in ivec2 texel) {
  if (farol_agreedSamples == 0.0 || texelFetch(farol_agreements, texel, 0).r < 0.5) return farol_samples;
  return farol_agreedSamples;
}
