// Light loop without culling: every light of the table.
// Thesis 2.2.1.3, several lights per shader
#include "shadePlain"

void farol_addAll(inout FarolShading s) {
  farol_addUnbounded(s);
  int first = farol_lightCounts.x + farol_lightCounts.y;
  for (int i = first; i < first + farol_lightCounts.z; i++) {
    // most lights do not reach the point: of these one texel is fetched, not two
    vec4 sphere = farol_lightSphere(i);
    vec3 toLight = farol_lightPosition(sphere) - s.positionVS;
    float range = farol_lightRange(sphere);
    if (dot(toLight, toLight) < range * range) farol_addRead(s, i, sphere, farol_lightEmission(i), false);
  }
#ifdef FAROL_AREA_LIGHTS
  if (farol_areaCounts.y > 0 && farol_isPhysical(s)) {
    FarolAreaLobe lobe = FAROL_LOBE_OF(s);
    for (int i = first; i < first + farol_lightCounts.z; i++) farol_addListedArea(s, lobe, i);
  }
#endif
}

#define FAROL_FOR_EACH_LIGHT(positionVS) \
  for (int farol_i = 0; farol_i < farol_lightCounts.x; farol_i++) { \
    FarolLight farol_light = farol_directionalLight(farol_i); \
    FAROL_SHADE(farol_light) \
  } \
  int farol_end = farol_lightCounts.x + farol_lightCounts.y + farol_lightCounts.z; \
  for (int farol_i = farol_lightCounts.x; farol_i < farol_end; farol_i++) { \
    FarolLight farol_light = farol_localLight(farol_i, positionVS); \
    FAROL_SHADE(farol_light) \
  }
