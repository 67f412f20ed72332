// Encodes linear light to 0 to 1, in steps that look equal, and decodes it; leaves display-encoded colours as is.
// Karis 2013, Tone Mapping (weights of samples by 1 / (1 + luma)); a gamma of 2 after it
uniform bool farol_isLinear; // whether the picture is linear light

vec4 farol_toPerceptual(const in vec4 color) {
  if (!farol_isLinear) return color;
  vec3 c = clamp(color.rgb, 0.0, 6e4);
  return vec4(sqrt(c / (1.0 + max(c.r, max(c.g, c.b)))), color.a);
}

vec4 farol_fromPerceptual(const in vec4 color) {
  if (!farol_isLinear) return color;
  vec3 c = color.rgb * color.rgb;
  return vec4(c / max(1.0 - max(c.r, max(c.g, c.b)), 1e-5), color.a);
}
