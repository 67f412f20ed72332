// Walks the light list of the pixel's tile. Whoever includes it defines FAROL_LISTED_BITS(bits, start, positionVS): the bits
// of a word of the list, lights start to start + 31, that count at a position.
// Olsson and Assarsson 2011, Tiled Shading; the bit lists after Drobot 2017, Improved Culling for Tiled and Clustered Rendering
#include "lightTiles"
#include "viewport"
uniform highp usampler2D farol_tileMask;
uniform highp usampler2D farol_tileSummary;

int farol_tileOf(const in vec2 fragCoord) {
  ivec2 tile = ivec2(fragCoord - farol_offset) >> farol_tiles.x;
  return tile.y * farol_tiles.y + tile.x;
}

FarolLight farol_unboundedLight(const in int record, const in vec3 positionVS) {
  if (record < farol_lightCounts.x) return farol_directionalLight(record);
  return farol_localLight(record, positionVS);
}

// lists of one quad need no summary
uvec4 farol_summaryOf(const in int list, const in int page) {
  if (farol_tiles.w == 1) return uvec4(farol_tileRun.y > 0 ? 1u : 0u, 0u, 0u, 0u);
  return texelFetch(farol_tileSummary, farol_listTexel(list * farol_tileRun.z + page), 0);
}

// opens five loops; farol_record is the light's record
#define FAROL_FOR_EACH_LISTED(positionVS) \
  int farol_list = farol_tileOf(gl_FragCoord.xy); \
  for (int farol_page = 0; farol_page < farol_tileRun.z; farol_page++) { \
    uvec4 farol_summary = farol_summaryOf(farol_list, farol_page); \
    for (int farol_word = 0; farol_word < 4 && farol_summary != uvec4(0u); farol_word++, farol_summary = uvec4(farol_summary.yzw, 0u)) \
      for (uint farol_quads = farol_summary.x; farol_quads != 0u; farol_quads &= farol_quads - 1u) { \
        int farol_start = (farol_page * 128 + farol_word * 32 + farol_lowestBit(farol_quads)) * 128; \
        uvec4 farol_mask = texelFetch(farol_tileMask, farol_listTexel(farol_list * farol_tiles.w + (farol_start >> 7)), 0); \
        for (; farol_mask != uvec4(0u); farol_mask = uvec4(farol_mask.yzw, 0u), farol_start += 32) \
          for (uint farol_bits = FAROL_LISTED_BITS(farol_mask.x, farol_start, positionVS); farol_bits != 0u; farol_bits &= farol_bits - 1u) { \
            int farol_record = farol_tileRun.x + farol_start + farol_lowestBit(farol_bits);
#define FAROL_END_LISTED }}}

#define FAROL_FOR_EACH_LIGHT(positionVS) \
  for (int farol_i = 0; farol_i < farol_tileRun.x; farol_i++) { FarolLight farol_light = farol_unboundedLight(farol_i, positionVS); FAROL_SHADE(farol_light) } \
  FAROL_FOR_EACH_LISTED(positionVS) FarolLight farol_light = farol_localLight(farol_record, positionVS); FAROL_SHADE(farol_light) FAROL_END_LISTED
