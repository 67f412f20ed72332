// Shades a pixel of the G-buffer by its tile's light list and writes the picture with depth, in one pass.
// Andersson 2009, Parallel Graphics in Frostbite; Lauritzen 2010, Deferred Rendering for Current and Future Pipelines
#include "shadeSurface"
#include "output"
#include "heatMap"
#include "heatScale"
uniform highp sampler2D farol_overdrawMap;
uniform vec2 farol_size;
uniform int farol_view; // 0 final picture, 1 direct light alone, 2 heat map of lights, or lights and draws, per pixel
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy - farol_offset);
float depth = farol_gDepthAt(pixel);
gl_FragDepth = depth;
if (farol_view == 2) {
  float counted = texelFetch(farol_overdrawMap, pixel, 0).r;
  if (!farol_isEmptyPixel(pixel, depth)) {
    vec3 positionVS = farol_surfacePosition(pixel, depth, farol_size);
    counted += float(farol_lightCounts.x + farol_lightCounts.y);
    FAROL_FOR_EACH_LISTED(positionVS) counted += 1.0; FAROL_END_LISTED
  }
  gl_FragColor = vec4(farol_heatMap(counted * farol_heatScale), 1.0);
} else if (farol_isEmptyPixel(pixel, depth)) {
  if (farol_background.a < 0.0) discard;
  gl_FragColor = farol_background;
} else {
  FarolShading shading = farol_beginShading(pixel, depth, farol_size);
#ifdef FAROL_HAS_MASKS
  farol_turn = farol_diskTurn();
#endif
  farol_addAll(shading);
  vec3 radiance = farol_endShading(shading, pixel);
  if (farol_view == 0) radiance += farol_gAccumulationAt(pixel).rgb;
  int flags = shading.flags;
  gl_FragColor = farol_output(radiance, -shading.positionVS.z, farol_isToneMapped(flags), farol_hasFog(flags),
    farol_isDithered(flags));
}
