// Sum of all ambient and hemisphere lights, exact since each is linear in the normal: a constant and three slopes.
// Farol; three's HemisphereLight: mix(ground, sky, 0.5 * dot(normal, up) + 0.5)
uniform vec3 farol_ambient[4];

vec3 farol_ambientIrradiance(const in vec3 normalVS) {
  return farol_ambient[0] + farol_ambient[1] * normalVS.x + farol_ambient[2] * normalVS.y + farol_ambient[3] * normalVS.z;
}
