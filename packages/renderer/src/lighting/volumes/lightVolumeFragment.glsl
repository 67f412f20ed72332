// One light over the pixels of its volume, added up; how a pixel is lit, the chunk before says (volumeLighting).
// Hargreaves and Harris 2004, Deferred Shading; thesis 3.2.3.2
#include "lightTable"
#include "unproject"
flat in highp int farol_record;
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy);
float depth = FAROL_SURFACE_DEPTH(pixel);
if (FAROL_IS_EMPTY(pixel, depth)) discard;
#ifdef FAROL_COUNT
FAROL_COUNT_PIXEL(1.0)
#else
vec4 sphere = farol_lightSphere(farol_record);
vec3 toLight = farol_lightPosition(sphere) - FAROL_SURFACE_POSITION(pixel, depth);
float range = farol_lightRange(sphere);
if (dot(toLight, toLight) >= range * range) discard;
FAROL_BEGIN_PIXEL
FAROL_BOUNDED_PIXEL(farol_record)
FAROL_END_PIXEL
#endif
