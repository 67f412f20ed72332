// Light loop over the lights that reach every pixel, then over the list of the pixel's tile.
// Olsson and Assarsson 2011, Tiled Shading; Drobot 2017, Improved Culling for Tiled and Clustered Rendering
#include "addPoint"
#include "lightTileLists"

// of 32 bits for quads (128 lights each) from quad start on, keeps those of quads first to last
uint farol_quadsFrom(const in uint bits, const in int start, const in int first, const in int last) {
  return bits & farol_bitsFrom(start, first, last);
}

// opens loops over the lights in quads firstQuad to lastQuad of farol_tile's list
#define FAROL_FOR_EACH_LISTED_IN(firstQuad, lastQuad) \
  FAROL_FOR_EACH_IN_QUADS(farol_summaryOf(farol_tile, farol_page), \
    farol_quadsFrom(farol_summary.x, farol_word, firstQuad, lastQuad))
#define FAROL_FOR_EACH_LISTED(positionVS) \
  ivec2 farol_tile = farol_tileOf(gl_FragCoord.xy); \
  FAROL_FOR_EACH_LISTED_IN(0, farol_tiles.w - 1)

// separate loops for plain point lights, area lights and all others, so that each loop is short
void farol_addAll(inout FarolShading s) {
  farol_addUnbounded(s);
  ivec2 farol_tile = farol_tileOf(gl_FragCoord.xy);
  // the shading model is tested once, before the loop
  if (farol_isPhysical(s)) {
    FAROL_FOR_EACH_LISTED_IN(0, farol_tileRun.w - 1) farol_addPoint(s, farol_record, true); FAROL_END_LISTED
  } else {
    FAROL_FOR_EACH_LISTED_IN(0, farol_tileRun.w - 1) farol_addPoint(s, farol_record, false); FAROL_END_LISTED
  }
  if (FAROL_OTHER_LIGHTS > 0) {
    FAROL_FOR_EACH_LISTED_IN(farol_tileRun.w, farol_tiles.w - 1) farol_addLocal(s, farol_record); FAROL_END_LISTED
  }
#ifdef FAROL_AREA_LIGHTS
  if (farol_areaCounts.y > 0 && farol_isPhysical(s)) {
    FarolAreaLobe lobe = FAROL_LOBE_OF(s);
    FAROL_FOR_EACH_LISTED_IN(farol_tileRun.w, farol_tiles.w - 1)
      farol_addListedArea(s, lobe, farol_record);
    FAROL_END_LISTED
  }
#endif
}

#define FAROL_FOR_EACH_LIGHT(positionVS) FAROL_SHADE_ALL(positionVS)
