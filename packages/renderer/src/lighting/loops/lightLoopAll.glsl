// Light loop without culling: every light of the table.
// Thesis 2.2.1.3, several lights per shader
#include "shadePlain"

void farol_addAll(inout FarolShading s) {
  farol_addUnbounded(s);
  int first = farol_lightCounts.x + farol_lightCounts.y;
  for (int i = first; i < first + farol_lightCounts.z; i++) {
    // fetches one texel, not two, of the many lights that do not reach the point
    vec4 sphere = farol_lightSphere(i);
    if (distance(farol_lightPosition(sphere), s.positionVS) < farol_lightRange(sphere)) farol_addLocal(s, i);
  }
#ifdef FAROL_AREA_LIGHTS
  if (farol_areaCounts.y > 0 && farol_isPhysical(s)) {
    FarolAreaLobe lobe = FAROL_LOBE_OF(s);
    for (int i = first; i < first + farol_lightCounts.z; i++) farol_addListedArea(s, lobe, i);
  }
#endif
}

#define FAROL_FOR_EACH_LIGHT(positionVS) \
  int farol_end = farol_lightCounts.x + farol_lightCounts.y + farol_lightCounts.z; \
  for (int farol_i = 0; farol_i < farol_end; farol_i++) { \
    FarolLight farol_light = farol_lightAt(farol_i, positionVS); \
    FAROL_SHADE(farol_light) \
  }
