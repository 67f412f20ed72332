// The part of a light's colour that its shadow map and cookie let through; replaces lightMask once a light has them.
// Farol
#include "lightShadow"
#define FAROL_HAS_MASKS
#define FAROL_MASK farol_lightMask
#define FAROL_MASKED(color, mask, toLight, positionVS, shadowNormalVS, receives) \
  ((mask) > 0 ? (color) * FAROL_MASK(mask, false, toLight, positionVS, shadowNormalVS, receives) : (color))
