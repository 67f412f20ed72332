// Light loop of multipass lighting over only the list of the pixel's tile, which holds the lights of fields.
// Olsson and Assarsson 2011, Tiled Shading
#include "lightLoopTiled"

void farol_addFields(inout FarolShading s) {
  FAROL_FOR_EACH_LISTED(s.positionVS) farol_addLocal(s, farol_record); FAROL_END_LISTED
}
#define farol_addAll(s) farol_addFields(s)
#undef FAROL_FOR_EACH_LIGHT
#define FAROL_FOR_EACH_LIGHT(positionVS) FAROL_SHADE_LISTED(positionVS)
