// What of a light passes to a point: all of it, while no light has a shadow map, a cookie or layers (else lightMaskOn).
// Farol
#define FAROL_MASKED(color, mask, toLight, positionVS, shadowNormalVS, receives) (color)
