// Reads a pixel of the thin G-buffer; layout in gbuffer/thinGBufferLayout.ts.
// Engel 2009, The Light Pre-Pass Renderer (ShaderX7 8.5)
#include "octahedralNormal"
#include "unproject"
uniform highp sampler2D farol_thinSurface;
uniform highp sampler2D farol_thinDepth;

// texel of a buffer of the given size; depth: 0..1 as in the depth buffer
vec3 farol_thinPosition(const in ivec2 texel, const in vec2 size, const in float depth) {
  return farol_unproject((vec2(texel) + 0.5) / size, depth);
}
