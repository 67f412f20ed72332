// Reads a pixel of the G-buffer; layout in gbuffer/gbufferLayout.ts.
// Farol
#include "gbufferTextures"
#include "octahedralNormal"
#include "readPixel"
#include "storedDistance"
#include "surfaceFlags"
#include "unproject"
// x: 0 no distances are stored, 1 they are, perspective, 2 orthographic; y: 1 if flags, not depth, tell empty pixels
uniform highp ivec2 farol_gStored;
#undef FAROL_POSITION_AT
#define FAROL_POSITION_AT(pixel) farol_surfacePosition(pixel, farol_gDepthAt(pixel), farol_readSize)

struct FarolSurface {
  vec3 positionVS; // position of the surface, view space (m)
  vec3 normalVS;
  vec3 albedo; // albedo, linear RGB
  vec4 material; // material attachment as stored, see gbufferLayout.ts
  vec4 accumulation; // rgb: emissive and indirect light (linear radiance); a: Phong shininess
  int flags; // flags of the surface, see surfaceFlags.glsl
};

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
  surface.material = farol_gMaterialAt(pixel);
  surface.accumulation = farol_gAccumulationAt(pixel);
  surface.positionVS = farol_surfacePosition(pixel, depth, size);
  return surface;
}
