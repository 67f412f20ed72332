// Reads one light of the table, and returns the light that arrives at a point: direction, colour, and the extension
// record if any.
// Farol; types of lights: three.js and thesis 3.2.5.3
#include "lightTable"
#include "areaLight"
#include "lightAttenuation"

struct FarolLight {
  vec3 direction; // direction to the light, view space, unit length
  vec3 color; // irradiance of a surface that faces the light
  float distance; // distance to the light (m), 0 for a directional light
  float attenuation; // factor on the colour, by distance and angle
  int extension; // record of the extension, 0 for none; negative: the extension of an area light
  int mask; // record of the mask (shadow map, cookie, layers), 0 when there is none
};

// exponent: falloff exponent of the thesis's spot light, -1 for three's penumbra
float farol_angularAttenuation(const in float angleCosine, const in float cutoff, const in float penumbra,
  const in float exponent) {
  if (exponent >= 0.0) return angleCosine > cutoff ? pow(max(angleCosine, 0.0), exponent) : 0.0;
  return smoothstep(cutoff, penumbra, angleCosine);
}

float farol_extendedAttenuation(const in int extension, const in float lightDistance, const in float range,
  const in float decay) {
  vec4 falloff = farol_extensionFalloff(extension);
  if (farol_extensionIsNearFar(falloff))
    return farol_nearFarAttenuation(lightDistance, farol_extensionNear(falloff), farol_extensionFar(falloff));
  if (farol_extensionIsPolynomial(falloff))
    return farol_polynomialAttenuation(lightDistance, farol_extensionFactors(falloff), range);
  return farol_distanceAttenuation(lightDistance, range, decay);
}

FarolLight farol_directionalLight(const in int record) {
  FarolLight light;
  light.direction = farol_lightDirection(record);
  vec4 emission = farol_lightEmission(record);
  light.color = farol_lightColor(emission);
  light.distance = 0.0;
  light.attenuation = 1.0;
  light.extension = light.mask = 0;
  if (farol_lightHasDetails(emission)) {
    vec4 details = farol_lightDetails(record);
    light.mask = farol_lightMaskRecord(details);
    light.extension = farol_lightExtensionRecord(details);
  }
  return light;
}

FarolLight farol_localLight(const in int record, const in vec3 positionVS) {
  FarolLight light;
  vec4 sphere = farol_lightSphere(record);
  vec4 emission = farol_lightEmission(record);
  vec3 toLight = farol_lightPosition(sphere) - positionVS;
  float range = farol_lightRange(sphere);
  float lightDistance = light.distance = length(toLight);
  light.direction = normalize(toLight);
  light.extension = light.mask = 0;
  if (farol_lightIsPlain(emission)) {
    light.attenuation = farol_distanceAttenuation(lightDistance, range, farol_lightPlainDecay(emission));
  } else { // a spot or area light, a light with Farol's options (an extension), or a light with a mask
    vec4 cone = farol_lightCone(record);
    vec4 details = farol_lightDetails(record);
    light.mask = farol_lightMaskRecord(details);
    light.extension = farol_lightExtensionRecord(details);
    FAROL_SET_AREA
    float angleCosine = dot(light.direction, farol_lightAxis(cone));
    light.attenuation = farol_angularAttenuation(
      angleCosine, farol_lightCutoff(cone), farol_lightPenumbra(details), farol_lightExponent(details));
    if (light.attenuation > 0.0) {
      float decay = farol_lightOtherDecay(emission);
      light.attenuation *= light.extension > 0
        ? farol_extendedAttenuation(light.extension, lightDistance, range, decay)
        : farol_distanceAttenuation(lightDistance, range, decay);
    }
  }
  light.color = farol_lightColor(emission) * light.attenuation;
  return light;
}

// light that arrives at a point; record: a directional or local light
FarolLight farol_lightAt(const in int record, const in vec3 positionVS) {
  if (record < farol_lightCounts.x) return farol_directionalLight(record);
  return farol_localLight(record, positionVS);
}
