// Light loop without culling: every light of the table. FAROL_SHADE(light) is given by whoever includes it.
// Thesis 2.2.1.3, several lights per shader
#include "shadePlain"
#define FAROL_SHADE_ALL(shading) \
  farol_addUnbounded(shading); \
  for (int farol_i = farol_lightCounts.x + farol_lightCounts.y; \
    farol_i < farol_lightCounts.x + farol_lightCounts.y + farol_lightCounts.z; \
    farol_i++) farol_addBounded(shading, farol_i);
#define FAROL_FOR_EACH_LIGHT(positionVS) \
  for (int farol_i = 0; farol_i < farol_lightCounts.x; farol_i++) { \
    FarolLight farol_light = farol_directionalLight(farol_i); FAROL_SHADE(farol_light) } \
  for (int farol_i = farol_lightCounts.x; farol_i < farol_lightCounts.x + farol_lightCounts.y + farol_lightCounts.z; \
    farol_i++) { FarolLight farol_light = farol_localLight(farol_i, positionVS); FAROL_SHADE(farol_light) }
