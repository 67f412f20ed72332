// Attenuation of a local light with distance (m) and angle; the falloffs of three.js and of the thesis.
// Lagarde and de Rousiers 2014, Moving Frostbite to PBR, equation 26; glTF KHR_lights_punctual
//? farol_distanceAttenuation(2.0, 0.0, 2.0) == 0.25
//? farol_distanceAttenuation(4.0, 4.0, 2.0) == 0.0
//? farol_distanceAttenuation(2.0, 4.0, 1.0) == 0.439453125
//? farol_boundedAttenuation(4.0, 0.25, 2.0) == 0.2197265625
//? farol_boundedAttenuation(4.0, 0.25, 1.0) == 0.439453125
//? farol_boundedAttenuation(16.0, 0.0, 0.5) == 0.5
//? farol_nearFarAttenuation(1.0, 2.0, 4.0) == 1.0
//? farol_nearFarAttenuation(4.0, 2.0, 4.0) == 0.0
//? farol_polynomialAttenuation(2.0, vec3(1.0, 0.5, 0.5), 10.0) == 0.25
//? farol_polynomialAttenuation(11.0, vec3(1.0, 0.5, 0.5), 10.0) == 0.0
//? farol_polynomialAttenuation(2.0, vec3(1.0, 0.5, 0.5), 0.0) == 0.25
float farol_distanceAttenuation(const in float lightDistance, const in float range, const in float decay) {
  float falloff = 1.0 / max(decay == 2.0 ? lightDistance * lightDistance : pow(lightDistance, decay), 0.01);
  if (range > 0.0) {
    float ratio = lightDistance / range;
    ratio *= ratio;
    float window = clamp(1.0 - ratio * ratio, 0.0, 1.0);
    falloff *= window * window;
  }
  return falloff;
}

// farol_distanceAttenuation of a light with a range, from squared distances: needs no root, and for decay 2 no power
float farol_boundedAttenuation(const in float distanceSquared, const in float ratioSquared, const in float decay) {
  float window = 1.0 - ratioSquared * ratioSquared;
  float falloff = window * window / max(decay == 2.0 ? distanceSquared : pow(distanceSquared, 0.5 * decay), 0.01);
  return falloff;
}

float farol_nearFarAttenuation(const in float lightDistance, const in float nearDistance, const in float farDistance) {
  return clamp((farDistance - lightDistance) / max(farDistance - nearDistance, 1e-6), 0.0, 1.0);
}

// factors: constant, linear (1/m), quadratic (1/m²); range: 0 for none
float farol_polynomialAttenuation(const in float lightDistance, const in vec3 factors, const in float range) {
  if (range > 0.0 && lightDistance > range) return 0.0;
  return 1.0 / max(factors.x + lightDistance * (factors.y + lightDistance * factors.z), 0.01);
}
