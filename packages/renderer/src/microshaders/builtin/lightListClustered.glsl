// Walks the lights of the pixel's cluster: the bits of its tile's mask that lie in the range of its depth's bin.
// Drobot 2017, Improved Culling for Tiled and Clustered Rendering in Call of Duty: Infinite Warfare; lights/LightGrid.ts
#include "shadePlain"
#include "lightTiles"
#include "viewport"
uniform highp usampler2D farol_gridMasks; // a row of texels for a row of tiles, quad by quad
uniform highp usampler2D farol_gridBins; // first rank, last rank << 16
uniform highp ivec4 farol_grid; // pixels a side, as a power of two; tiles in y; words of lights that count for every depth; first record
uniform highp vec3 farol_gridDepth; // shift (m), start, scale

uvec2 farol_depthBin(const in float depth) {
  if (farol_lightCounts.z == 0) return uvec2(1u, 0u);
  int bin = int(float(floatBitsToInt(max(depth + farol_gridDepth.x, 0.0)) - floatBitsToInt(farol_gridDepth.y)) * farol_gridDepth.z);
  uint ranks = texelFetch(farol_gridBins, ivec2(clamp(bin, 0, 1023), 0), 0).x;
  return uvec2(ranks & 65535u, ranks >> 16);
}

FarolLight farol_unboundedLight(const in int record, const in vec3 positionVS) {
  if (record < farol_lightCounts.x) return farol_directionalLight(record);
  return farol_localLight(record, positionVS);
}

// the bits of a word whose lights' ranks are in the range, or which count for every depth
uint farol_rankBits(const in int start, const in ivec2 ranks, const in int deep) {
  uint bits = farol_bitsFrom(start, ranks.x, ranks.y);
  return start < deep ? bits | farol_bitsFrom(start, 0, deep - 1) : bits;
}

// opens three loops; farol_record is the light's record
#define FAROL_FOR_EACH_LISTED(positionVS) \
  ivec2 farol_tile = ivec2(gl_FragCoord.xy - farol_offset) >> farol_grid.x; \
  ivec2 farol_ranks = ivec2(farol_depthBin(-(positionVS).z)); \
  int farol_deep = farol_grid.z * 32; \
  int farol_deepQuads = (farol_deep + 127) >> 7; \
  int farol_lastQuad = max(farol_ranks.x <= farol_ranks.y ? farol_ranks.y >> 7 : -1, farol_deepQuads - 1); \
  for (int farol_quad = farol_deepQuads > 0 ? 0 : farol_ranks.x >> 7; farol_quad <= farol_lastQuad; \
       farol_quad = farol_quad + 1 < farol_deepQuads ? farol_quad + 1 : max(farol_quad + 1, farol_ranks.x >> 7)) { \
    uvec4 farol_mask = texelFetch(farol_gridMasks, ivec2(farol_tile.x, farol_quad * farol_grid.y + farol_tile.y), 0); \
    int farol_start = farol_quad * 128; \
    for (; farol_mask != uvec4(0u); farol_mask = uvec4(farol_mask.yzw, 0u), farol_start += 32) \
      for (uint farol_bits = farol_mask.x & farol_rankBits(farol_start, farol_ranks, farol_deep); \
           farol_bits != 0u; farol_bits &= farol_bits - 1u) { \
        int farol_record = farol_grid.w + farol_start + farol_lowestBit(farol_bits);
#define FAROL_END_LISTED }}
#define FAROL_SHADE_LISTED(shading) \
  FAROL_FOR_EACH_LISTED(shading.positionVS) farol_addBounded(shading, farol_record); FAROL_END_LISTED
#define FAROL_SHADE_ALL(shading) farol_addUnbounded(shading); FAROL_SHADE_LISTED(shading)

#define FAROL_FOR_EACH_LIGHT(positionVS) \
  for (int farol_i = 0; farol_i < farol_grid.w; farol_i++) { FarolLight farol_light = farol_unboundedLight(farol_i, positionVS); FAROL_SHADE(farol_light) } \
  FAROL_FOR_EACH_LISTED(positionVS) FarolLight farol_light = farol_localLight(farol_record, positionVS); FAROL_SHADE(farol_light) FAROL_END_LISTED
