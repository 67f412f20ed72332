// Share of a light's colour that passes its shadow map and cookie; replaces lightMask once a light has either.
// Farol
#include "lightShadow"
#define FAROL_HAS_MASKS
#define FAROL_MASK farol_lightMask
vec3 farol_masked(const in vec3 color, const in int mask, const in vec3 toLight, const in vec3 positionVS,
  const in vec3 shadowNormalVS, const in bool receives) {
  return mask > 0 ? color * FAROL_MASK(mask, false, toLight, positionVS, shadowNormalVS, receives) : color;
}
