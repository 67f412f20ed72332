// Writes the sum and depth of multipass lighting to the pixels that its passes drew (alpha above 0).
// Farol
#include "output"
#include "unproject"
#include "heatMap"
#include "heatScale"
uniform highp sampler2D farol_accumulated;
uniform highp sampler2D farol_accumulatedDepth;
uniform highp sampler2D farol_overdrawMap;
uniform vec2 farol_size;
uniform int farol_view; // 0 final picture, 1 direct light alone, 2 heat map of lights, or lights and draws, per pixel
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy - farol_offset);
float depth = texelFetch(farol_accumulatedDepth, pixel, 0).r;
vec4 sum = texelFetch(farol_accumulated, pixel, 0);
if (farol_view == 2) {
  gl_FragColor = vec4(farol_heatMap((sum.r + texelFetch(farol_overdrawMap, pixel, 0).r) * farol_heatScale), 1.0);
} else if (sum.a <= 0.0) {
  if (farol_background.a < 0.0) discard;
  gl_FragColor = farol_background;
} else {
  float fogDepth = -farol_unproject((vec2(pixel) + 0.5) / farol_size, depth).z;
  // alpha below 1: only some samples of the pixel were drawn to
  gl_FragColor = farol_output(sum.rgb / sum.a, fogDepth, true, true, false) * sum.a;
  if (farol_background.a >= 0.0) gl_FragColor += farol_background * (1.0 - min(sum.a, 1.0));
}
gl_FragDepth = depth;
