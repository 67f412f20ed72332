// Reads a pixel of the G-buffer; layout in gbuffer/gbufferLayout.ts.
// Farol
#include "gbufferTextures"
#include "halfNormal"
#include "octahedralNormal"
#include "readPixel"
#include "storedDistance"
#include "surfaceFlags"
#include "unproject"
// x: stored distances: 0 none, 1 perspective, 2 orthographic; y: 1 if pixels with the farthest depth are empty only
// if their flags are 0; z: 1 for the layout of the quality 'lite'
uniform highp ivec3 farol_gStored;
#undef FAROL_POSITION_AT
#define FAROL_POSITION_AT(pixel) farol_surfacePosition(pixel, farol_gDepthAt(pixel), farol_readSize)

// normal of shadow look-ups for the surface in farol_readPixel: the vertex normal
#define FAROL_SHADOW_NORMAL_OF(s) farol_vertexNormal(s.flags, s.normalVS)
vec3 farol_vertexNormal(const in int flags, const in vec3 normalVS) {
  if (farol_hasVertexNormal(flags)) return farol_unpackNormal(farol_gAccumulationAt(farol_readPixel).a);
  return farol_isReversed(flags) ? -normalVS : normalVS;
}

struct FarolSurface {
  vec3 positionVS; // position of the surface, view space (m)
  vec3 normalVS;
  vec3 albedo; // albedo, linear RGB
  vec4 material; // material attachment as stored, see gbufferLayout.ts
  vec4 accumulation; // rgb: emissive and indirect light (linear radiance); a: Phong shininess
  int flags; // flags of the surface, see surfaceFlags.glsl
};

// material attachment of a pixel, in the layout of the quality 'full'
vec4 farol_materialAt(const in ivec2 pixel, const in int flags) {
  vec4 material = farol_gMaterialAt(pixel);
  if (farol_gStored.z == 0) return material;
  return farol_shadingModel(flags) == FAROL_PHONG ? material.rrra : vec4(material.rg, 0.2, 1.0);
}

// shininess of a Phong surface; above 0 also for Lambert surfaces, since pow(0, 0) is NaN, although they have no lobe
float farol_shininessAt(const in ivec2 pixel) {
  return farol_gStored.z == 0 ? farol_gAccumulationAt(pixel).a
    : max(exp2(13.0 * farol_gMaterialAt(pixel).g) - 1.0, 1e-3);
}

bool farol_isEmptyPixel(const in ivec2 pixel, const in float depth) {
  return farol_isEmpty(depth) && (farol_gStored.y == 0 || farol_gAlbedoAt(pixel).a == 0.0);
}

// position of a pixel's surface, view space (m)
vec3 farol_surfacePosition(const in ivec2 pixel, const in float depth, const in vec2 size) {
  float z = farol_gStored.x == 0
    ? farol_viewZ(depth)
    : -farol_unpackDistance(farol_gNormalAt(pixel).zw, farol_gStored.x == 2);
  return farol_unprojectAt((vec2(pixel) + 0.5) / size, z);
}

FarolSurface farol_readSurface(const in ivec2 pixel, const in float depth, const in vec2 size) {
  FarolSurface surface;
  vec4 albedo = farol_gAlbedoAt(pixel);
  surface.flags = farol_unpackFlags(albedo.a);
  surface.albedo = albedo.rgb * albedo.rgb;
  surface.normalVS = farol_decodeNormal(farol_gNormalAt(pixel).xy);
  surface.material = farol_materialAt(pixel, surface.flags);
  surface.accumulation = vec4(farol_gAccumulationAt(pixel).rgb, farol_shininessAt(pixel));
  surface.positionVS = farol_surfacePosition(pixel, depth, size);
  return surface;
}
