// What shaders have code for: the shapes of area lights. Here all; once there are area lights, those met so far.
// Farol
#define FAROL_AREA_SHAPES 7 // bits: 1 rectangles, 2 discs, 4 tubes
