// Shapes of area lights that shaders have code for: all; renderers replace it by those met so far.
// Farol
#define FAROL_AREA_SHAPES 7 // shapes of area lights in the scene, as bits: 1 rectangles, 2 discs, 4 tubes
