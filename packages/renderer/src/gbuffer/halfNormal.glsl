// Unit vector in one half float, to a quarter of a degree: the octahedral map in 247 × 247 steps.
// Cigolle et al. 2014, Survey of Representations for Independent Unit Vectors; IEEE 754 binary16
#include "octahedralNormal"
//? farol_unpackNormal(farol_packNormal(vec3(0.0, 0.0, 1.0))) == vec3(0.0, 0.0, 1.0)
//? farol_unpackNormal(farol_packNormal(vec3(0.0, -1.0, 0.0))) == vec3(0.0, -1.0, 0.0)
//? vec3 n = normalize(vec3(1.0, 2.0, 3.0)); dot(farol_unpackNormal(farol_packNormal(n)), n) > 0.99996 == true
//? vec3 n = normalize(vec3(-3.0, 1.0, -2.0)); dot(farol_unpackNormal(farol_packNormal(n)), n) > 0.99996 == true
// bits of half floats that drivers keep: no subnormal number, infinity or NaN; 30,720 of each sign
float farol_packNormal(const in vec3 normal) {
  vec2 place = floor((farol_encodeNormal(normal) * 0.5 + 0.5) * 246.0 + 0.5);
  uint code = uint(place.x * 247.0 + place.y);
  return unpackHalf2x16(code + (code < 30720u ? 1024u : 3072u)).x;
}

vec3 farol_unpackNormal(const in float stored) {
  uint bits = packHalf2x16(vec2(stored, 0.0));
  uint code = bits - (bits < 32768u ? 1024u : 3072u);
  return farol_decodeNormal(vec2(code / 247u, code % 247u) / 123.0 - 1.0);
}
