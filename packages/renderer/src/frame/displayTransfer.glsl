// The transfer function of sRGB and its inverse for each channel, also for values above 1.
// IEC 61966-2-1
//? farol_toDisplay(vec3(1.0)) == vec3(1.0)
//? farol_toLinear(vec3(0.0)) == vec3(0.0)
//? farol_toDisplay(farol_toLinear(vec3(0.5, 0.02, 0.9))) == vec3(0.5, 0.02, 0.9)
//? farol_toDisplay(farol_toLinear(vec4(0.1, 0.2, 0.3, 0.4))) == vec4(0.1, 0.2, 0.3, 0.4)
//? farol_toDisplay(farol_toLinear(vec4(0.1, 0.2, 0.3, 0.0))) == vec4(0.1, 0.2, 0.3, 0.0)
vec3 farol_toLinear(const in vec3 encoded) {
  return mix(encoded / 12.92, pow(max(encoded * 0.9478672986 + 0.0521327014, 0.0), vec3(2.4)),
    vec3(greaterThan(encoded, vec3(0.04045))));
}

vec3 farol_toDisplay(const in vec3 radiance) {
  return mix(radiance * 12.92, pow(max(radiance, 0.0), vec3(0.41666)) * 1.055 - 0.055,
    vec3(greaterThan(radiance, vec3(0.0031308))));
}

// factor that a premultiplied colour contains: alpha, or more where light was added to a transparent surface
float farol_multiplier(const in vec4 color) {
  return color.a < 1.0 ? max(max(color.r, max(color.g, color.b)), max(color.a, 1e-6)) : 1.0;
}

// linear RGB of a premultiplied colour, as in a canvas: converts the colour as it was before multiplication
vec4 farol_toLinear(const in vec4 encoded) {
  float multiplier = farol_multiplier(encoded);
  return vec4(farol_toLinear(encoded.rgb / multiplier) * multiplier, encoded.a);
}

vec4 farol_toDisplay(const in vec4 radiance) {
  float multiplier = farol_multiplier(radiance);
  return vec4(farol_toDisplay(radiance.rgb / multiplier) * multiplier, radiance.a);
}
