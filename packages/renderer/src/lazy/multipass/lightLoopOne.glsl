// Light loop of one light, farol_lightIndex: a pass of multipass lighting.
// Thesis 2.2.1.3, multipass lighting
#include "incidentLight"
uniform highp int farol_lightIndex;
#define FAROL_FOR_EACH_LIGHT(positionVS) { \
  FarolLight farol_light = farol_lightAt(farol_lightIndex, positionVS); \
  FAROL_SHADE(farol_light) \
}
