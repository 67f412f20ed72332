// Directional lights and lights without a range over every pixel, which the chunk before (volumeLighting) lights.
// Thesis 3.2.3.2
#include "lightTable"
#include "depthMode"
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy);
float depth = FAROL_SURFACE_DEPTH(pixel);
if (FAROL_IS_EMPTY(pixel, depth)) discard;
#ifdef FAROL_COUNT
FAROL_COUNT_PIXEL(float(farol_lightCounts.x + farol_lightCounts.y))
#else
FAROL_BEGIN_PIXEL
FAROL_UNBOUNDED_PIXEL
FAROL_END_PIXEL
#endif
