// three's getShadowMask() for what shows nothing but shadows: those of all lights that cast any, multiplied.
// three.js r187 shadowmask_pars_fragment
#include "lightMask"
uniform highp ivec2 farol_masks; // first record of the masks, their number
varying highp vec3 farol_maskPositionVS;
varying highp vec3 farol_maskNormalVS;

float farol_shadowMask() {
  float lit = 1.0;
#ifdef FAROL_HAS_MASKS
  if (receiveShadow)
    for (int i = 0; i < farol_masks.y; i++)
      lit *= farol_lightLit(farol_masks.x + i * 3, farol_maskPositionVS, farol_maskNormalVS);
#endif
  return lit;
}
