// Reads a pixel of the G-buffer; layout in gbuffer/gbufferLayout.ts.
// Farol
#include "octahedralNormal"
#include "storedDistance"
#include "unproject"
uniform highp sampler2D farol_gAccumulation;
uniform highp sampler2D farol_gNormal;
uniform lowp sampler2D farol_gAlbedo;
uniform lowp sampler2D farol_gMaterial;
uniform highp sampler2D farol_gDepth;
// x: distances along the view are stored, 1 in perspective, 2 orthographic; y: 1 where flags tell nothing from what is
// drawn at its depth
uniform highp ivec2 farol_gStored;

struct FarolSurface {
  vec3 positionVS; // m
  vec3 normalVS;
  vec3 albedo; // linear
  vec4 material; // as stored
  vec4 accumulation; // linear radiance; a: Phong shininess
  int flags; // low two bits: 0 unlit, 1 standard, 2 Phong, 3 Lambert; 4: fog; 8: tone mapped; 16: receives shadows
};

bool farol_isEmptyPixel(const in ivec2 pixel, const in float depth) {
  return farol_isEmpty(depth) && (farol_gStored.y == 0 || texelFetch(farol_gAlbedo, pixel, 0).a == 0.0);
}

// view space, m
vec3 farol_surfacePosition(const in ivec2 pixel, const in float depth, const in vec2 size) {
  float z = farol_gStored.x == 0
    ? farol_viewZ(depth)
    : -farol_unpackDistance(texelFetch(farol_gNormal, pixel, 0).zw, farol_gStored.x == 2);
  return farol_unprojectAt((vec2(pixel) + 0.5) / size, z);
}

FarolSurface farol_readSurface(const in ivec2 pixel, const in float depth, const in vec2 size) {
  FarolSurface surface;
  vec4 albedo = texelFetch(farol_gAlbedo, pixel, 0);
  surface.flags = int(albedo.a * 255.0 + 0.5);
  surface.albedo = albedo.rgb * albedo.rgb;
  surface.normalVS = farol_decodeNormal(texelFetch(farol_gNormal, pixel, 0).xy);
  surface.material = texelFetch(farol_gMaterial, pixel, 0);
  surface.accumulation = texelFetch(farol_gAccumulation, pixel, 0);
  surface.positionVS = farol_surfacePosition(pixel, depth, size);
  return surface;
}
