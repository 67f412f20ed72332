// Adds a listed plain point light to the sums of a surface, as farol_addLight does, in fewer steps.
// Farol; fetches the emission before the distance is computed, so that the two overlap in time
#include "shading"

// physical: farol_isPhysical(s), evaluated once before the loop; lights of other kinds are skipped
void farol_addPoint(inout FarolShading s, const in int record, const in bool physical) {
  vec4 sphere = farol_lightSphere(record);
  vec3 toLight = farol_lightPosition(sphere) - s.positionVS;
  float range = farol_lightRange(sphere);
  float distanceSquared = dot(toLight, toLight);
  vec4 emission = farol_lightEmission(record);
#ifdef STANDARD
  float ratio = distanceSquared / (range * range);
  if (ratio >= 1.0 || !farol_lightIsPlain(emission)) return;
  vec3 color = farol_lightColor(emission);
  color *= farol_boundedAttenuation(distanceSquared, ratio, farol_lightPlainDecay(emission));
  farol_addLight(s, toLight * inversesqrt(max(distanceSquared, 1e-12)), color, color);
#else
  // farol_addLight in fewer steps: returns early for lights behind the surface or out of range, normalises late
  float along = dot(s.normalVS, toLight);
  float rangeSquared = range * range;
  if (!(along > 0.0) || distanceSquared >= rangeSquared || !farol_lightIsPlain(emission)) return;
  float inverse = inversesqrt(max(distanceSquared, 1e-12));
  float dotNL = along * inverse;
  // irradiance for a colour of 1
  float arriving = dotNL * farol_boundedAttenuation(distanceSquared, distanceSquared / rangeSquared,
    farol_lightPlainDecay(emission));
  // half vector h = (l + v) / |l + v|, |l + v|² = 2 + 2 l·v = 4 (v·h)²
  float halfSquared = max(2.0 * inverse * dot(s.viewDirVS, toLight) + 2.0, 1e-8);
  float halfScale = inversesqrt(halfSquared);
  float dotNH = clamp((dotNL + s.dotNV) * halfScale, 0.0, 1.0);
  float fresnel = farol_schlickPower(0.5 * halfSquared * halfScale);
  float lobe = arriving * (physical
    ? farol_ggxLobe(s.alphaSquared, s.lambdaV, clamp(s.dotNV, 0.0, 1.0), dotNL, dotNH)
    : farol_blinnPhongLobe(s.alphaSquared, dotNH));
  vec3 color = farol_lightColor(emission);
  s.diffuse += arriving * (s.diffuse0 - s.diffuse90 * fresnel) * color;
  s.specular += lobe * color;
  s.grazing += lobe * fresnel * color;
#endif
}
