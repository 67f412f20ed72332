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
#ifdef FAROL_COUNT
farol_lighting = vec4(1.0, 0.0, 0.0, 0.0);
#else
vec4 centre = farol_lightTexel(farol_record, 0);
vec3 toLight = centre.xyz - farol_unproject(gl_FragCoord.xy / farol_size, depth);
if (dot(toLight, toLight) >= centre.w * centre.w) discard;
FarolShading shading = farol_beginShading(pixel, depth, farol_size);
farol_addBounded(shading, farol_record);
farol_lighting = vec4(farol_endShading(shading, pixel), 0.0);
#endif
