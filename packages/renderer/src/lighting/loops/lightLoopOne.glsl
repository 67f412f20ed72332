// Light loop of one light, farol_lightIndex: a pass of multipass lighting.
// Thesis 2.2.1.3, multipass lighting
#include "incidentLight"
uniform highp int farol_lightIndex;

FarolLight farol_onlyLight(const in vec3 positionVS) {
  if (farol_lightIndex < farol_lightCounts.x) return farol_directionalLight(farol_lightIndex);
  return farol_localLight(farol_lightIndex, positionVS);
}
#define FAROL_FOR_EACH_LIGHT(positionVS) \
  { FarolLight farol_light = farol_onlyLight(positionVS); FAROL_SHADE(farol_light) }
