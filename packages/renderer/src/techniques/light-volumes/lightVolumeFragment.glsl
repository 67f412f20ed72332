// Adds one light to the pixels of its volume; the chunk before (such as volumeLighting) shades a pixel.
// Hargreaves and Harris 2004, Deferred Shading; thesis 3.2.3.2
#include "lightTable"
#include "unproject"
flat in highp int farol_record;
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy);
float depth = farol_pixelDepth(pixel);
if (farol_isPixelEmpty(pixel, depth)) discard;
#ifdef FAROL_COUNT
farol_countPixel(1.0);
#else
vec4 sphere = farol_lightSphere(farol_record);
vec3 toLight = farol_lightPosition(sphere) - farol_pixelPosition(pixel, depth);
float range = farol_lightRange(sphere);
if (dot(toLight, toLight) >= range * range) discard;
FarolPixel lit = farol_beginPixel(pixel, depth);
// a plain point light does not light surfaces that face away: saves shading and blending
if (farol_lightIsPlain(farol_record) && !(dot(farol_pixelNormal(lit), toLight) > 0.0)) discard;
farol_addToPixel(lit, farol_record);
farol_endPixel(lit, pixel);
#endif
