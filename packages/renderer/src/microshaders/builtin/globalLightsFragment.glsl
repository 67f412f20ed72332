// Directional lights and lights without a range over every pixel of the G-buffer.
// Thesis 3.2.3.2
#include "shadeSurface"
uniform vec2 farol_size;
layout(location = 0) out highp vec4 farol_lighting;
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy);
float depth = texelFetch(farol_gDepth, pixel, 0).r;
if (depth >= 1.0) discard;
#ifdef FAROL_COUNT
farol_lighting = vec4(float(farol_lightCounts.x + farol_lightCounts.y), 0.0, 0.0, 0.0);
#else
FarolShading shading = farol_beginShading(pixel, depth, farol_size);
farol_addUnbounded(shading);
farol_lighting = vec4(farol_endShading(shading, pixel), 0.0);
#endif
