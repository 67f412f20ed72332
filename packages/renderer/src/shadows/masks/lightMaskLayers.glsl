// Replaces lightMaskOn once a light reaches only objects of its layers.
// Farol
#define FAROL_LAYERS
#ifdef FAROL_PER_VERTEX
#define FAROL_OBJECT_LAYERS farol_layersAttribute
#elif defined( FAROL_LAYERS_OF_OBJECT )
flat in highp vec2 farol_objectLayers; // layers of the drawn object: x low, y high 16 bits
#define FAROL_OBJECT_LAYERS farol_objectLayers
#else
uniform highp vec2 farol_layers; // layers of every object in the G-buffer: x low, y high 16 bits
#define FAROL_OBJECT_LAYERS farol_layers
#endif
#include "lightShadow"
#define FAROL_HAS_MASKS
bool farol_sharesLayer(const in int mask) {
  uvec2 layers = uvec2(farol_maskLayers(mask) + 0.5);
  return layers == uvec2(0u) || (layers & uvec2(FAROL_OBJECT_LAYERS + 0.5)) != uvec2(0u);
}
vec3 farol_layeredMask(const in int mask, const in bool isPoint, const in vec3 toLight, const in vec3 positionVS,
  const in vec3 shadowNormalVS, const in bool receives) {
  return farol_sharesLayer(mask) ? farol_lightMask(mask, isPoint, toLight, positionVS, shadowNormalVS, receives)
    : vec3(0.0);
}
#define FAROL_MASK farol_layeredMask
vec3 farol_masked(const in vec3 color, const in int mask, const in vec3 toLight, const in vec3 positionVS,
  const in vec3 shadowNormalVS, const in bool receives) {
  return mask > 0 ? color * FAROL_MASK(mask, false, toLight, positionVS, shadowNormalVS, receives) : color;
}
