// The curves and gradients of an emitter over a particle's life.
// Farol; baked by bakeCurves.ts
uniform highp sampler2D farol_particleCurves; // x: life (256 texels); y: 0: colour, opacity; 1: size, integral of spin

vec4 farol_particleCurve(const in int row, const in float share) {
  float at = clamp(share, 0.0, 1.0) * 255.0;
  int texel = int(at);
  vec4 before = texelFetch(farol_particleCurves, ivec2(texel, row), 0);
  return mix(before, texelFetch(farol_particleCurves, ivec2(min(texel + 1, 255), row), 0), at - float(texel));
}
