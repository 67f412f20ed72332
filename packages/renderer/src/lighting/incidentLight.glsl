// Reads one light of the table and gives what arrives at a point: direction, colour, and the extension record if any.
// Farol; the light types are those of three.js and of thesis 3.2.5.3
#include "lightTable"
#include "lightAttenuation"

struct FarolLight {
  vec3 direction; // to the light, view space, unit length
  vec3 color; // irradiance of a surface that faces the light
  float distance; // to the light (m), 0 for a directional light
  float attenuation; // what the colour was multiplied by
  int extension; // record of the extension, 0 when there is none
  int mask; // record of its shadow and cookie, 0 when there is none
};

// exponent: of the thesis's spot light, -1 for three's penumbra
float farol_angularAttenuation(const in float angleCosine, const in float cutoff, const in float penumbra,
  const in float exponent) {
  if (exponent >= 0.0) return angleCosine > cutoff ? pow(max(angleCosine, 0.0), exponent) : 0.0;
  return smoothstep(cutoff, penumbra, angleCosine);
}

float farol_extendedAttenuation(const in int extension, const in float lightDistance, const in float range,
  const in float decay) {
  vec4 falloff = farol_lightTexel(extension, 3);
  if (falloff.w == 1.0) return farol_nearFarAttenuation(lightDistance, falloff.x, falloff.y);
  if (falloff.w == 2.0) return farol_polynomialAttenuation(lightDistance, falloff.xyz, range);
  return farol_distanceAttenuation(lightDistance, range, decay);
}

FarolLight farol_directionalLight(const in int index) {
  FarolLight light;
  light.direction = farol_lightTexel(index, 0).xyz;
  vec4 color = farol_lightTexel(index, 1);
  light.color = color.rgb;
  light.distance = 0.0;
  light.attenuation = 1.0;
  light.extension = light.mask = 0;
  if (color.w != 0.0) {
    vec4 more = farol_lightTexel(index, 3);
    light.mask = int(more.z);
    light.extension = int(more.w);
  }
  return light;
}

FarolLight farol_localLight(const in int index, const in vec3 positionVS) {
  FarolLight light;
  vec4 centre = farol_lightTexel(index, 0);
  vec4 color = farol_lightTexel(index, 1);
  vec3 toLight = centre.xyz - positionVS;
  float lightDistance = light.distance = length(toLight);
  light.direction = normalize(toLight);
  light.extension = light.mask = 0;
  if (color.w >= 0.0) { // a plain point light: w is its decay
    light.attenuation = farol_distanceAttenuation(lightDistance, centre.w, color.w);
  } else { // a spot light, a light of the thesis or one with a mask: w is -1 - decay
    vec4 axis = farol_lightTexel(index, 2);
    vec4 cone = farol_lightTexel(index, 3);
    light.mask = int(cone.z);
    light.extension = int(cone.w);
    float angleCosine = dot(light.direction, axis.xyz);
    light.attenuation = farol_angularAttenuation(angleCosine, axis.w, cone.x, cone.y);
    if (light.attenuation > 0.0) {
      light.attenuation *= light.extension > 0
        ? farol_extendedAttenuation(light.extension, lightDistance, centre.w, -1.0 - color.w)
        : farol_distanceAttenuation(lightDistance, centre.w, -1.0 - color.w);
    }
  }
  light.color = color.rgb * light.attenuation;
  return light;
}
