// Sum of all ambient and hemisphere lights, exact since each is linear in the normal: a constant and three slopes.
// Farol; three's HemisphereLight: mix(ground, sky, 0.5 * dot(normal, up) + 0.5)
uniform vec3 farol_ambient[4];

vec3 farol_ambientIrradiance(const in vec3 normalVS) {
  // zero normals of a geometry are NaN here
  return farol_ambient[0] + (dot(normalVS, normalVS) > 0.0 ? mat3(farol_ambient[1], farol_ambient[2], farol_ambient[3]) * normalVS : vec3(0.0));
}
