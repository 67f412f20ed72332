// Adds the lighting buffer to the G-buffer's accumulation and writes the picture with its depth.
// Farol
#include "gbufferRead"
#include "output"
#include "heatMap"
#include "heatScale"
uniform highp sampler2D farol_lightingMap;
uniform highp sampler2D farol_overdrawMap;
uniform vec2 farol_size;
uniform int farol_view; // 0 final picture, 1 direct light alone, 2 heat map of lights, or lights and draws, per pixel
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy - farol_offset);
float depth = farol_gDepthAt(pixel);
vec3 lighting = texelFetch(farol_lightingMap, pixel, 0).rgb;
if (farol_view == 2) {
  gl_FragColor = vec4(farol_heatMap((lighting.r + texelFetch(farol_overdrawMap, pixel, 0).r) * farol_heatScale), 1.0);
} else if (farol_isEmptyPixel(pixel, depth)) {
  if (farol_background.a < 0.0) discard;
  gl_FragColor = farol_background;
} else {
  int flags = farol_unpackFlags(farol_gAlbedoAt(pixel).a);
  vec3 radiance = farol_view == 1 ? lighting : lighting + farol_gAccumulationAt(pixel).rgb;
  vec3 positionVS = farol_surfacePosition(pixel, depth, farol_size);
  gl_FragColor = farol_output(radiance, -positionVS.z, farol_isToneMapped(flags), farol_hasFog(flags),
    farol_isDithered(flags));
}
gl_FragDepth = depth;
