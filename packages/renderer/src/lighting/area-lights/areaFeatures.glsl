// What shaders have code for: the shapes of area lights. Here all; once there are area lights, those met so far.
// Farol
#define FAROL_AREA_RECTANGLES
#define FAROL_AREA_DISCS
#define FAROL_AREA_TUBES
