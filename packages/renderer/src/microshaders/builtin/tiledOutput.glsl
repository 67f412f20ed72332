// Lights a pixel of the G-buffer by its light list and writes the picture with its depth, in one pass.
// Andersson 2009, Parallel Graphics in Frostbite; Lauritzen 2010, Deferred Rendering for Current and Future Rendering Pipelines
#include "shadeSurface"
#include "output"
#include "heatMap"
#include "heatScale"
uniform highp sampler2D farol_overdrawMap;
uniform vec2 farol_size;
uniform int farol_view; // 0 final, 1 lighting, 2 counts
#define FAROL_SHADE(light) farol_lightsEvaluated += 1.0; if (light.attenuation > 0.0) farol_shade(shading, light);
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy - farol_offset);
float depth = texelFetch(farol_gDepth, pixel, 0).r;
float farol_lightsEvaluated = 0.0;
gl_FragColor = vec4(0.0, 0.0, 0.0, 1.0);
if (depth < 1.0) {
  FarolSurface surface = farol_readSurface(pixel, depth, farol_size);
  FarolShading shading = farol_beginShading(surface);
  FAROL_FOR_EACH_LIGHT(shading.positionVS)
  vec3 radiance = farol_endShading(shading, surface);
  if (farol_view == 0) radiance += surface.accumulation.rgb;
  gl_FragColor = farol_output(radiance, -surface.positionVS.z, (surface.flags & 8) != 0, (surface.flags & 4) != 0);
} else if (farol_view != 2) discard;
if (farol_view == 2) {
  float counted = farol_lightsEvaluated + texelFetch(farol_overdrawMap, pixel, 0).r;
  gl_FragColor = vec4(farol_heatMap(counted * farol_heatScale), 1.0);
}
gl_FragDepth = depth;
