// Adds directional lights and lights without a range at every pixel, by functions of the chunk before (volumeLighting).
// Thesis 3.2.3.2
#include "lightTable"
#include "depthMode"
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy);
float depth = farol_pixelDepth(pixel);
if (farol_isPixelEmpty(pixel, depth)) discard;
#ifdef FAROL_COUNT
farol_countPixel(float(farol_lightCounts.x + farol_lightCounts.y));
#else
FarolPixel lit = farol_beginPixel(pixel, depth);
farol_addUnboundedToPixel(lit);
farol_endPixel(lit, pixel);
#endif
