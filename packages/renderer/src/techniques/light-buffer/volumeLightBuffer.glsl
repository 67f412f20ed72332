// Light volumes over the thin G-buffer: adds a light to a texel's sums in the light buffer.
// Engel 2009, The Light Pre-Pass Renderer (ShaderX7 8.5)
#include "thinGBufferRead"
#include "sumLight"
uniform vec2 farol_size;
layout(location = 0) out highp vec4 farol_sums0;
layout(location = 1) out highp vec4 farol_sums1;
layout(location = 2) out highp vec4 farol_sums2;
#ifdef FAROL_AREA_LIGHTS
layout(location = 3) out highp vec4 farol_sums3;
#endif

struct FarolPixel {
  vec3 positionVS; // view space, m
  FarolLobe lobe;
  FarolLightSums sums;
};

float farol_pixelDepth(const in ivec2 pixel) {
  return texelFetch(farol_thinDepth, pixel, 0).r;
}

bool farol_isPixelEmpty(const in ivec2 pixel, const in float depth) {
  return (farol_thinStored != 0 || farol_isEmpty(depth)) && texelFetch(farol_thinSurface, pixel, 0).w == 0.0;
}

// view space, m
vec3 farol_pixelPosition(const in ivec2 pixel, const in float depth) {
  return farol_thinPosition(pixel, farol_size);
}

FarolPixel farol_beginPixel(const in ivec2 pixel, const in float depth) {
  FarolPixel lit;
  farol_readPixel = pixel;
  farol_readSize = farol_size;
  lit.positionVS = farol_thinPosition(pixel, farol_size);
  vec4 thin = texelFetch(farol_thinSurface, pixel, 0);
  vec3 viewDirVS = farol_perspective == 0.0 ? vec3(0.0, 0.0, 1.0) : normalize(-lit.positionVS);
  lit.lobe = farol_lobe(thin.z, thin.w, farol_decodeNormal(thin.xy), viewDirVS);
  lit.sums = farol_noSums();
  return lit;
}

vec3 farol_pixelNormal(const in FarolPixel lit) {
  return lit.lobe.normalVS;
}

// record: a light with a range
void farol_addToPixel(inout FarolPixel lit, const in int record) {
  farol_sumLight(lit.sums, lit.lobe, lit.positionVS, farol_localLight(record, lit.positionVS));
}

void farol_addUnboundedToPixel(inout FarolPixel lit) {
  for (int i = 0; i < farol_lightCounts.x; i++)
    farol_sumLight(lit.sums, lit.lobe, lit.positionVS, farol_directionalLight(i));
  for (int i = 0; i < farol_lightCounts.y; i++)
    farol_sumLight(lit.sums, lit.lobe, lit.positionVS, farol_localLight(farol_lightCounts.x + i, lit.positionVS));
}

void farol_endPixel(const in FarolPixel lit, const in ivec2 pixel) {
  farol_sums0 = vec4(lit.sums.diffuse, lit.sums.specularF90.r);
  farol_sums1 = vec4(lit.sums.rest, lit.sums.specularF90.g);
  farol_sums2 = vec4(lit.sums.specularF0, lit.sums.specularF90.b);
#ifdef FAROL_AREA_LIGHTS
  farol_sums3 = vec4(lit.sums.area, 0.0);
#endif
}

void farol_countPixel(const in float count) {
  farol_sums0 = vec4(count, 0.0, 0.0, 0.0);
  farol_sums1 = farol_sums2 = vec4(0.0);
#ifdef FAROL_AREA_LIGHTS
  farol_sums3 = vec4(0.0);
#endif
}
