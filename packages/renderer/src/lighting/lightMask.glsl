// The part of a light's colour that reaches a point: all, while no light has a shadow map, a cookie or layers.
// Farol; once a light has a mask, lightMaskOn or lightMaskLayers takes the place of this chunk
// mask: record of the light's mask, 0 for none; toLight: from the point (m); receives: false where shadows do not count
vec3 farol_masked(const in vec3 color, const in int mask, const in vec3 toLight, const in vec3 positionVS,
  const in vec3 shadowNormalVS, const in bool receives) {
  return color;
}
