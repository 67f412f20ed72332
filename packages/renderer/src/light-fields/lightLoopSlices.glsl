// Light loop over the pixel's cluster in scenes with light fields: quads of 128 lights that are in its tile's list
// and reach the slice of its depth.
// Olsson, Billeter and Assarsson 2012, Clustered Deferred and Forward Shading; Drobot 2017 (z-binning)
#include "lightTileLists"
#include "lightSlice"
uniform highp usampler2D farol_sliceQuads;

// bits of the quads in one page of the tile's list that reach the slice
uvec4 farol_sliceOf(const in ivec2 tile, const in int page, const in int slice) {
  uvec4 filled = farol_summaryOf(tile, page);
  for (int i = 0; i < 4; i++) {
    if (filled[i] != 0u) filled[i] &= texelFetch(farol_sliceQuads, ivec2(slice, page * 4 + i), 0).r;
  }
  return filled;
}

#define FAROL_FOR_EACH_LISTED(positionVS) \
  ivec2 farol_tile = farol_tileOf(gl_FragCoord.xy); \
  int farol_slice = int(clamp(farol_slicePlace(-(positionVS).z), 0.0, 255.0)); \
  FAROL_FOR_EACH_IN_QUADS(farol_sliceOf(farol_tile, farol_page, farol_slice), farol_summary.x)

void farol_addAll(inout FarolShading s) {
  farol_addUnbounded(s);
  FAROL_FOR_EACH_LISTED(s.positionVS) farol_addLocal(s, farol_record); FAROL_END_LISTED
#ifdef FAROL_AREA_LIGHTS
  if (farol_areaCounts.y > 0 && farol_isPhysical(s)) {
    FarolAreaLobe lobe = FAROL_LOBE_OF(s);
    FAROL_FOR_EACH_LISTED(s.positionVS) farol_addListedArea(s, lobe, farol_record); FAROL_END_LISTED
  }
#endif
}

#define FAROL_FOR_EACH_LIGHT(positionVS) FAROL_SHADE_ALL(positionVS)
