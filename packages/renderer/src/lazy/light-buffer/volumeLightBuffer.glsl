// Light volumes over the thin G-buffer: a texel's sums of light into the light buffer.
// Engel 2009, The Light Pre-Pass Renderer (ShaderX7 8.5)
#include "thinGBufferRead"
#include "sumLight"
uniform vec2 farol_size;
layout(location = 0) out highp vec4 farol_sums0;
layout(location = 1) out highp vec4 farol_sums1;
layout(location = 2) out highp vec4 farol_sums2;
#define FAROL_SURFACE_DEPTH(pixel) texelFetch(farol_thinDepth, pixel, 0).r
#define FAROL_IS_EMPTY(pixel, depth) \
  ((farol_thinStored != 0 || farol_isEmpty(depth)) && texelFetch(farol_thinSurface, pixel, 0).w == 0.0)
#define FAROL_SURFACE_POSITION(pixel, depth) farol_thinPosition(pixel, farol_size)
#define FAROL_BEGIN_PIXEL \
  vec3 positionVS = farol_thinPosition(pixel, farol_size); \
  vec4 thin = texelFetch(farol_thinSurface, pixel, 0); \
  FarolLobe lobe = farol_lobe(thin.z, thin.w, farol_decodeNormal(thin.xy), \
    farol_perspective == 0.0 ? vec3(0.0, 0.0, 1.0) : normalize(-positionVS)); \
  FarolLightSums sums = FarolLightSums(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
#define FAROL_UNBOUNDED_PIXEL \
  for (int i = 0; i < farol_lightCounts.x; i++) farol_sumLight(sums, lobe, positionVS, farol_directionalLight(i)); \
  for (int i = 0; i < farol_lightCounts.y; i++) \
    farol_sumLight(sums, lobe, positionVS, farol_localLight(farol_lightCounts.x + i, positionVS));
#define FAROL_BOUNDED_PIXEL(record) farol_sumLight(sums, lobe, positionVS, farol_localLight(record, positionVS));
#define FAROL_END_PIXEL \
  farol_sums0 = vec4(sums.diffuse, sums.specularF90.r); \
  farol_sums1 = vec4(sums.rest, sums.specularF90.g); \
  farol_sums2 = vec4(sums.specularF0, sums.specularF90.b);
#define FAROL_COUNT_PIXEL(count) farol_sums0 = vec4(count, 0.0, 0.0, 0.0); farol_sums1 = vec4(0.0); \
  farol_sums2 = vec4(0.0);
