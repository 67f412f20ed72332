// Shared by loops over the light lists of tiles: the tile's list, and the lights of its quads.
// Olsson and Assarsson 2011, Tiled Shading; Drobot 2017, Improved Culling for Tiled and Clustered Rendering (bit lists)
#include "shadePlain"
#include "lightTiles"
#include "viewport"
uniform highp usampler2D farol_tileMask;
uniform highp usampler2D farol_tileSummary;

ivec2 farol_tileOf(const in vec2 fragCoord) {
  return ivec2(fragCoord - farol_offset) >> FAROL_TILE_SHIFT;
}

// bits of the non-empty quads of one page (128 quads) of a tile's list; lists of one quad have no summary texture
uvec4 farol_summaryOf(const in ivec2 tile, const in int page) {
  if (farol_tiles.w == 1) return uvec4(farol_tileRun.y > 0 ? 1u : 0u, 0u, 0u, 0u);
  return texelFetch(farol_tileSummary, farol_listTexel(tile, farol_tiles.yz, page), 0);
}

// Opens five loops over the list of farol_tile; farol_record is a light's record.
// summary: bits of the quads of farol_page that may hold a light; quads: bits to loop over, among those of
// farol_summary.x, which begin at quad farol_word
#define FAROL_FOR_EACH_IN_QUADS(summary, quads) \
  for (int farol_page = 0; farol_page < farol_tileRun.z; farol_page++) { \
    uvec4 farol_summary = summary; \
    for (int farol_word = farol_page * 128; farol_summary != uvec4(0u); \
         farol_word += 32, farol_summary = uvec4(farol_summary.yzw, 0u)) \
      for (uint farol_quads = quads; farol_quads != 0u; farol_quads &= farol_quads - 1u) { \
        int farol_start = (farol_word + farol_lowestBit(farol_quads)) * 128; \
        ivec2 farol_texel = farol_listTexel(farol_tile, farol_tiles.yz, farol_start >> 7); \
        uvec4 farol_mask = texelFetch(farol_tileMask, farol_texel, 0); \
        for (; farol_mask != uvec4(0u); farol_mask = uvec4(farol_mask.yzw, 0u), farol_start += 32) \
          for (uint farol_bits = farol_mask.x; farol_bits != 0u; farol_bits &= farol_bits - 1u) { \
            int farol_record = farol_tileRun.x + farol_start + farol_lowestBit(farol_bits);
#define FAROL_END_LISTED }}}

#define FAROL_SHADE_LISTED(positionVS) \
  FAROL_FOR_EACH_LISTED(positionVS) \
    FarolLight farol_light = farol_localLight(farol_record, positionVS); \
    FAROL_SHADE(farol_light) \
  FAROL_END_LISTED
// shades by the lights that are in no list, then by the tile's list
#define FAROL_SHADE_ALL(positionVS) \
  for (int farol_i = 0; farol_i < farol_tileRun.x; farol_i++) { \
    FarolLight farol_light = farol_lightAt(farol_i, positionVS); \
    FAROL_SHADE(farol_light) \
  } \
  FAROL_SHADE_LISTED(positionVS)
