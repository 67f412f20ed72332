// Light's colour that reaches a point: all of it, until a light has a shadow map, a cookie or layers; then
// lightMaskOn or lightMaskLayers replaces this chunk.
// Farol
// mask: record of the light's mask, 0 for none; toLight: from the point (m); receives: false to ignore shadows
vec3 farol_masked(const in vec3 color, const in int mask, const in vec3 toLight, const in vec3 positionVS,
  const in vec3 shadowNormalVS, const in bool receives) {
  return color;
}
