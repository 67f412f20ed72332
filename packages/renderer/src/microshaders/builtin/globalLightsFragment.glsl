// Directional lights and lights without a range over every pixel of the G-buffer.
// Thesis 3.2.3.2
#include "shadeSurface"
uniform vec2 farol_size;
layout(location = 0) out highp vec4 farol_lighting;
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy);
float depth = texelFetch(farol_gDepth, pixel, 0).r;
if (depth >= 1.0) discard;
int farol_last = farol_lightCounts.x + farol_lightCounts.y;
#ifdef FAROL_COUNT
farol_lighting = vec4(float(farol_last), 0.0, 0.0, 0.0);
#else
FarolSurface surface = farol_readSurface(pixel, depth, farol_size);
FarolShading shading = farol_beginShading(surface);
for (int i = 0; i < farol_lightCounts.x; i++) farol_shade(shading, farol_directionalLight(i));
for (int i = farol_lightCounts.x; i < farol_last; i++) farol_shade(shading, farol_localLight(i, shading.positionVS));
farol_lighting = vec4(farol_endShading(shading, surface), 0.0);
#endif
