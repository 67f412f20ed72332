// Reads one light of the table and gives what arrives at a point: direction, colour, and the extension record if any.
// Farol; the light types are those of three.js and of thesis 3.2.5.3
#include "lightTable"
#include "lightAttenuation"

struct FarolLight {
  vec3 direction; // to the light, view space, unit length
  vec3 color; // irradiance of a surface that faces the light
  float attenuation; // what the colour was multiplied by
  int extension; // record of the extension, 0 when there is none
};

FarolLight farol_directionalLight(const in int index) {
  FarolLight light;
  light.direction = farol_lightTexel(index, 0).xyz;
  vec4 color = farol_lightTexel(index, 1);
  light.color = color.rgb;
  light.attenuation = 1.0;
  light.extension = color.w == 0.0 ? 0 : int(farol_lightTexel(index, 3).w);
  return light;
}

FarolLight farol_localLight(const in int index, const in vec3 positionVS) {
  FarolLight light;
  vec4 centre = farol_lightTexel(index, 0);
  vec4 color = farol_lightTexel(index, 1);
  vec3 toLight = centre.xyz - positionVS;
  float lightDistance = length(toLight);
  light.direction = normalize(toLight);
  light.extension = 0;
  if (color.w >= 0.0) { // a plain point light: w is its decay
    light.attenuation = farol_distanceAttenuation(lightDistance, centre.w, color.w);
  } else { // a spot light or a light of the thesis: w is -1 - decay
    vec4 axis = farol_lightTexel(index, 2);
    vec4 cone = farol_lightTexel(index, 3);
    light.extension = int(cone.w);
    float angleCosine = dot(light.direction, axis.xyz);
    float angular = cone.y >= 0.0
      ? (angleCosine > axis.w ? pow(max(angleCosine, 0.0), cone.y) : 0.0)
      : smoothstep(axis.w, cone.x, angleCosine);
    light.attenuation = 0.0;
    if (angular > 0.0) {
      vec4 falloff = vec4(0.0);
      if (light.extension > 0) falloff = farol_lightTexel(light.extension, 3);
      light.attenuation = angular * (
        falloff.w == 1.0 ? farol_nearFarAttenuation(lightDistance, falloff.x, falloff.y)
        : falloff.w == 2.0 ? farol_polynomialAttenuation(lightDistance, falloff.xyz, centre.w)
        : farol_distanceAttenuation(lightDistance, centre.w, -1.0 - color.w));
    }
  }
  light.color = color.rgb * light.attenuation;
  return light;
}
