// What of a light passes to a point: its colour by its shadow map and cookie; takes the place of lightMask once one is met.
// Farol
#include "lightShadow"
#define FAROL_HAS_MASKS
#define FAROL_MASK farol_lightMask
#define FAROL_MASKED(color, mask, toLight, positionVS, shadowNormalVS, receives) ((mask) > 0 ? (color) * FAROL_MASK(mask, false, toLight, positionVS, shadowNormalVS, receives) : (color))
