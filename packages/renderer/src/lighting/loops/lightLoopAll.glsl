// Light loop without culling: every light of the table.
// Thesis 2.2.1.3, several lights per shader
#include "shadePlain"

#ifdef FAROL_AREA_LIGHTS
void farol_addUnboundedArea(inout FarolShading s, const in FarolLight light) {
  FAROL_ADD_AREA(light)
}
#endif

void farol_addAll(inout FarolShading s) {
  int first = farol_lightCounts.x + farol_lightCounts.y;
  // one loop for all kinds: a software rasteriser runs a loop's code once more than it goes round
  for (int i = 0; i < first + farol_lightCounts.z; i++) {
    // most lights do not reach the point: one texel is fetched for such a light, not two
    vec4 sphere = farol_lightSphere(i);
    bool hasRange = i >= first;
    if (!hasRange || distance(farol_lightPosition(sphere), s.positionVS) < farol_lightRange(sphere))
      farol_addRead(s, i, sphere, farol_lightEmission(i), false, i < farol_lightCounts.x, hasRange);
  }
#ifdef FAROL_AREA_LIGHTS
  for (int i = farol_lightCounts.x; i < first; i++) farol_addUnboundedArea(s, farol_lightAt(i, s.positionVS));
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
