// Adds a listed light that is no plain point light to the sums of a surface.
// Farol
#include "shading"

// adds a plain point light, unmasked or fully let through by its mask; sphere: texel of its record
void farol_addPlain(inout FarolShading s, const in vec4 sphere, const in vec3 color, const in float decay) {
  vec3 toLight = farol_lightPosition(sphere) - s.positionVS;
  float range = farol_lightRange(sphere);
  float distanceSquared = dot(toLight, toLight);
  float ratio = distanceSquared / (range * range);
  if (ratio >= 1.0) return;
  vec3 arriving = color * farol_boundedAttenuation(distanceSquared, ratio, decay);
  farol_addLight(s, toLight * inversesqrt(max(distanceSquared, 1e-12)), arriving, arriving);
}

// adds a light with a range, unless it is a plain point light or an area light; isPlain: a point light whose mask
// lets all through here; both texels are fetched before a branch, so that the reads overlap
void farol_addOther(inout FarolShading s, const in int record, const in bool isLit, const in bool isPlain) {
  vec4 sphere = farol_lightSphere(record);
  vec4 emission = farol_lightEmission(record);
#ifdef FAROL_POINT_MASKS
  if (isPlain) {
    farol_addPlain(s, sphere, farol_lightColor(emission), farol_lightOtherDecay(emission));
    return;
  }
#endif
  if (!farol_lightIsPlain(emission)) farol_addRead(s, record, sphere, emission, isLit);
}
