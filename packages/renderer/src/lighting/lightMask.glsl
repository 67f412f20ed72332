// What of a light passes to a point: all of it, while no light has a shadow map, a cookie or layers (else lightMaskOn).
// Farol
// mask: its record, 0 for none; toLight: from the point (m); receives: false where shadows do not count
vec3 farol_masked(const in vec3 color, const in int mask, const in vec3 toLight, const in vec3 positionVS,
  const in vec3 shadowNormalVS, const in bool receives) {
  return color;
}
