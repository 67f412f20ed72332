// Light loop of multipass lighting: only the light farol_lightIndex, or none if below 0.
// Thesis 2.2.1.3, multipass lighting
#include "incidentLight"
uniform highp int farol_lightIndex;
#define FAROL_FOR_EACH_LIGHT(positionVS) if (farol_lightIndex >= 0) { \
  FarolLight farol_light = farol_lightAt(farol_lightIndex, positionVS); \
  FAROL_SHADE(farol_light) \
}
