// Part of three's getShadowMask() in materials that show only shadows: the product of the shadows of Farol's lights.
// three.js r187 shadowmask_pars_fragment
#include "lightMask"
uniform highp ivec2 farol_masks; // x: light table record of the first mask; y: number of masks
varying highp vec3 farol_maskPositionVS;
varying highp vec3 farol_maskNormalVS;

float farol_shadowMask() {
  float lit = 1.0;
#ifdef FAROL_HAS_MASKS
  if (receiveShadow)
    for (int i = 0; i < farol_masks.y; i++)
      lit *= farol_lightLit(farol_masks.x + i * FAROL_RECORDS_PER_MASK, farol_maskPositionVS, farol_maskNormalVS);
#endif
  return lit;
}
