// Light loop over the pixel's cluster: the bits of its tile's mask that lie in the range of its depth's bin.
// Drobot 2017, Improved Culling for Tiled and Clustered Rendering in Call of Duty; lights/LightGrid.ts
#include "addOther"
#include "addPoint"
#include "shadePlain"
#include "lightTiles"
#include "viewport"
uniform highp usampler2D farol_gridMasks; // one bit a light, 128 in a texel; a row of texels for each row of tiles
uniform highp usampler2D farol_gridBins; // ranks of the lights in each bin of depth: first | last << 16
// x: log2 of a tile's side (pixels); y: tiles in y; z: words of 32 lights that reach every depth; w: first record
uniform highp ivec4 farol_grid;
uniform highp vec3 farol_gridDepth; // bin of a distance d (m): (float bits of (d + x) - float bits of y) * z

uvec2 farol_depthBin(const in float depth) {
  if (farol_lightCounts.z == 0) return uvec2(1u, 0u);
  int bin = int(float(floatBitsToInt(max(depth + farol_gridDepth.x, 0.0)) - floatBitsToInt(farol_gridDepth.y))
    * farol_gridDepth.z);
  uint ranks = texelFetch(farol_gridBins, ivec2(clamp(bin, 0, 1023), 0), 0).x;
  return uvec2(ranks & 65535u, ranks >> 16);
}

// one word of the tile's mask: lights with ranks in the range, and lights that reach every depth
uint farol_listedBits(const in ivec2 tile, const in int word, const in ivec2 ranks) {
  uvec4 quad = texelFetch(farol_gridMasks, ivec2(tile.x, (word >> 2) * farol_grid.y + tile.y), 0);
  uvec2 half2 = (word & 2) == 0 ? quad.xy : quad.zw;
  uint bits = (word & 1) == 0 ? half2.x : half2.y;
  return word < farol_grid.z ? bits : bits & farol_bitsFrom(word * 32, ranks.x, ranks.y);
}

#if defined( FAROL_HAS_MASKS ) && defined( FAROL_TILE_SHADOWS )
// per tile of 8 × 8 pixels, a texel for each two words (32 lights each): bits of lights whose shadow maps leave the
// whole tile lit, then of lights that are wholly shadowed there; both bits: a point light that lights all of the tile
uniform highp usampler2D farol_tileShadows;
uniform highp int farol_tileShadowWords; // number of words of farol_tileShadows for each tile; 0 while there are none

uvec2 farol_tileMarks(const in int word) {
  if (word >= farol_tileShadowWords) return uvec2(0u);
  ivec2 tile = ivec2(gl_FragCoord.xy - farol_offset) >> 3;
  uvec4 marks = texelFetch(farol_tileShadows, ivec2(tile.x * (farol_tileShadowWords >> 1) + (word >> 1), tile.y), 0);
  return (word & 1) == 0 ? marks.xy : marks.zw;
}
#else
uvec2 farol_tileMarks(const in int word) {
  return uvec2(0u);
}
#endif

// Opens two loops over the lights of a pixel's cluster; farol_record is a light's record.
// without: whether to skip lights known to be wholly shadowed in the tile (farol_marks)
#define FAROL_FOR_EACH_UNMARKED(positionVS, without) \
  ivec2 farol_tile = ivec2(gl_FragCoord.xy - farol_offset) >> farol_grid.x; \
  ivec2 farol_ranks = ivec2(farol_depthBin(-(positionVS).z)); \
  int farol_lastWord = max(farol_ranks.x <= farol_ranks.y ? farol_ranks.y >> 5 : -1, farol_grid.z - 1); \
  for (int farol_word = farol_grid.z > 0 ? 0 : farol_ranks.x >> 5; farol_word <= farol_lastWord; \
       farol_word = farol_word + 1 < farol_grid.z ? farol_word + 1 : max(farol_word + 1, farol_ranks.x >> 5)) { \
    uvec2 farol_marks = (without) ? farol_tileMarks(farol_word) : uvec2(0u); \
    uint farol_listed = farol_listedBits(farol_tile, farol_word, farol_ranks) & (farol_marks.x | ~farol_marks.y); \
    for (uint farol_bits = farol_listed; farol_bits != 0u; farol_bits &= farol_bits - 1u) { \
      int farol_record = farol_grid.w + farol_word * 32 + farol_lowestBit(farol_bits);
#define FAROL_FOR_EACH_LISTED(positionVS) FAROL_FOR_EACH_UNMARKED(positionVS, false)
#define FAROL_END_LISTED }}

// tests only if there are masked or area lights, since other lists have plain ones: the test costs time (0.3 ms in
// docs/attempts/shadow-lookups.md: "no loop over plain lights where there are none")
bool farol_mayHavePlain() {
#if defined( FAROL_HAS_MASKS ) || defined( FAROL_AREA_LIGHTS )
  return FAROL_PLAIN_LIGHTS > 0;
#else
  return true;
#endif
}

// separate loops for plain point lights, area lights and all others, so that each loop is short
void farol_addAll(inout FarolShading s) {
  farol_addUnbounded(s);
  if (farol_mayHavePlain()) {
    // the shading model is tested once, before the loop
    if (farol_isPhysical(s)) {
      FAROL_FOR_EACH_LISTED(s.positionVS) farol_addPoint(s, farol_record, true); FAROL_END_LISTED
    } else {
      FAROL_FOR_EACH_LISTED(s.positionVS) farol_addPoint(s, farol_record, false); FAROL_END_LISTED
    }
  }
  if (FAROL_OTHER_LIGHTS > 0) {
    FAROL_FOR_EACH_UNMARKED(s.positionVS, farol_receivesShadows(s.flags))
      uvec2 mark = farol_marks & (farol_bits & (~farol_bits + 1u));
      farol_addOther(s, farol_record, mark.x != 0u, (mark.x & mark.y) != 0u);
    FAROL_END_LISTED
  }
#ifdef FAROL_AREA_LIGHTS
  if (farol_areaCounts.y > 0 && farol_isPhysical(s)) {
    FarolAreaLobe lobe = FAROL_LOBE_OF(s);
    FAROL_FOR_EACH_UNMARKED(s.positionVS, farol_receivesShadows(s.flags))
      farol_addListedArea(s, lobe, farol_record);
    FAROL_END_LISTED
  }
#endif
}

#define FAROL_FOR_EACH_LIGHT(positionVS) \
  for (int farol_i = 0; farol_i < farol_grid.w; farol_i++) { \
    FarolLight farol_light = farol_lightAt(farol_i, positionVS); \
    FAROL_SHADE(farol_light) \
  } \
  FAROL_FOR_EACH_LISTED(positionVS) \
    FarolLight farol_light = farol_localLight(farol_record, positionVS); \
    FAROL_SHADE(farol_light) \
  FAROL_END_LISTED
