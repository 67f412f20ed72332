// Sum of all ambient and hemisphere lights, each linear in the normal: a constant and three slopes.
// Farol; three's HemisphereLight: mix(ground, sky, 0.5 * dot(normal, up) + 0.5)
uniform vec3 farol_ambient;
// change of the ambient irradiance along x, y and z of the normal, view space
uniform mat3 farol_ambientSlopes;

vec3 farol_ambientIrradiance(const in vec3 normalVS) {
  // a NaN, from normalizing a zero normal, becomes zero
  vec3 normal = abs(normalVS.x) <= 2.0 ? normalVS : vec3(0.0);
  return farol_ambient + farol_ambientSlopes * normal;
}
