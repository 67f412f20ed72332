// Unit vector to two numbers in -1..1 and back, by the octahedral map.
// Cigolle et al. 2014, Survey of Representations for Independent Unit Vectors, https://jcgt.org/published/0003/02/01/
//? farol_encodeNormal(vec3(0.0, 0.0, 1.0)) == vec2(0.0)
//? farol_encodeNormal(vec3(0.0, 0.0, -1.0)) == vec2(1.0)
//? farol_decodeNormal(vec2(1.0, 0.0)) == vec3(1.0, 0.0, 0.0)
//? vec3 n = normalize(vec3(1.0, 2.0, 3.0)); farol_decodeNormal(farol_encodeNormal(n)) == n
//? vec3 n = normalize(vec3(-3.0, 1.0, -2.0)); farol_decodeNormal(farol_encodeNormal(n)) == n
vec2 farol_encodeNormal(const in vec3 normal) {
  vec3 n = normal / (abs(normal.x) + abs(normal.y) + abs(normal.z));
  return n.z >= 0.0 ? n.xy : (1.0 - abs(n.yx)) * vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
}

vec3 farol_decodeNormal(const in vec2 encoded) {
  vec3 n = vec3(encoded, 1.0 - abs(encoded.x) - abs(encoded.y));
  if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
  return n.z <= 1.0 ? normalize(n) : vec3(0.0); // NaN, a surface without a normal, gives zero: no light reaches it
}
