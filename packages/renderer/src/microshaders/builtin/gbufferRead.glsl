// Reads a pixel of the G-buffer; layout in gbuffer/gbufferLayout.ts.
// Farol
#include "octahedralNormal"
#include "unproject"
uniform highp sampler2D farol_gAccumulation;
uniform highp sampler2D farol_gNormal;
uniform lowp sampler2D farol_gAlbedo;
uniform lowp sampler2D farol_gMaterial;
uniform highp sampler2D farol_gDepth;

struct FarolSurface {
  vec3 positionVS; // m
  vec3 normalVS;
  vec3 albedo; // linear
  vec4 material; // as stored
  vec4 accumulation; // linear radiance; a: Phong shininess
  int flags; // low two bits: 0 unlit, 1 standard, 2 Phong, 3 Lambert; 4: fog; 8: tone mapped; 16: receives shadows
};

FarolSurface farol_readSurface(const in ivec2 pixel, const in float depth, const in vec2 size) {
  FarolSurface surface;
  vec4 albedo = texelFetch(farol_gAlbedo, pixel, 0);
  surface.flags = int(albedo.a * 255.0 + 0.5);
  surface.albedo = albedo.rgb * albedo.rgb;
  surface.normalVS = farol_decodeNormal(texelFetch(farol_gNormal, pixel, 0).xy);
  surface.material = texelFetch(farol_gMaterial, pixel, 0);
  surface.accumulation = texelFetch(farol_gAccumulation, pixel, 0);
  surface.positionVS = farol_unproject((vec2(pixel) + 0.5) / size, depth);
  return surface;
}
