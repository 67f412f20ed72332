// Reads a pixel of the thin G-buffer; layout in thinGBufferLayout.ts.
// Engel 2009, The Light Pre-Pass Renderer (ShaderX7 8.5)
#include "octahedralNormal"
#include "readPixel"
#include "storedDistance"
#include "unproject"
uniform highp sampler2D farol_thinSurface;
uniform highp sampler2D farol_thinDepth; // depth texture, or the attachment of distances if farol_thinStored is not 0
// 0: no stored distances; 1: distances, perspective; 2: distances, orthographic; plus 4: normals too
uniform highp int farol_thinStored;

#undef FAROL_POSITION_AT
#define FAROL_POSITION_AT(pixel) farol_thinPosition(pixel, farol_readSize)

// view-space position at a texel of a buffer of the given size
vec3 farol_thinPosition(const in ivec2 texel, const in vec2 size) {
  vec2 depth = texelFetch(farol_thinDepth, texel, 0).rg;
  float z = farol_thinStored == 0 ? farol_viewZ(depth.r) : -farol_unpackDistance(depth, (farol_thinStored & 3) == 2);
  return farol_unprojectAt((vec2(texel) + 0.5) / size, z);
}

// normal of shadow look-ups for the surface in farol_readPixel: the vertex normal, where stored
#define FAROL_SHADOW_NORMAL_OF(s) farol_thinVertexNormal(s.normalVS)
vec3 farol_thinVertexNormal(const in vec3 normalVS) {
  return farol_thinStored < 4 ? normalVS : farol_decodeNormal(texelFetch(farol_thinDepth, farol_readPixel, 0).zw);
}
