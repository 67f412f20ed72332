// The transfer function of sRGB and its inverse, a channel at a time, values above 1 included.
// IEC 61966-2-1
//? farol_toDisplay(vec3(1.0)) == vec3(1.0)
//? farol_toLinear(vec3(0.0)) == vec3(0.0)
//? farol_toDisplay(farol_toLinear(vec3(0.5, 0.02, 0.9))) == vec3(0.5, 0.02, 0.9)
vec3 farol_toLinear(const in vec3 encoded) {
  return mix(encoded / 12.92, pow(max(encoded * 0.9478672986 + 0.0521327014, 0.0), vec3(2.4)),
    vec3(greaterThan(encoded, vec3(0.04045))));
}

vec3 farol_toDisplay(const in vec3 radiance) {
  return mix(radiance * 12.92, pow(max(radiance, 0.0), vec3(0.41666)) * 1.055 - 0.055,
    vec3(greaterThan(radiance, vec3(0.0031308))));
}
