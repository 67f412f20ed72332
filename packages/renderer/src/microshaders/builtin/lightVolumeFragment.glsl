// One light over the pixels of its volume, added to the lighting buffer.
// Hargreaves and Harris 2004, Deferred Shading; thesis 3.2.3.2
#include "shadeSurface"
uniform vec2 farol_size;
flat in highp int farol_record;
layout(location = 0) out highp vec4 farol_lighting;
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy);
float depth = texelFetch(farol_gDepth, pixel, 0).r;
if (depth >= 1.0) discard;
vec3 positionVS = farol_unproject(gl_FragCoord.xy / farol_size, depth);
#ifdef FAROL_COUNT
farol_lighting = vec4(1.0, 0.0, 0.0, 0.0);
#else
FarolLight light = farol_localLight(farol_record, positionVS);
if (light.attenuation <= 0.0) discard;
FarolSurface surface = farol_readSurface(pixel, depth, farol_size);
FarolShading shading = farol_beginShading(surface);
farol_shade(shading, light);
farol_lighting = vec4(farol_endShading(shading, surface), 0.0);
#endif
