// Fog between the eye and each surface: the light that it adds, or its transmittance.
// Wronski 2014, Volumetric Fog
#include "gbufferRead"
#include "media"
#include "viewport"
uniform vec2 farol_size;
uniform int farol_view; // 0 light, 1 transmittance
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy - farol_offset);
float depth = farol_gDepthAt(pixel);
vec4 media = farol_mediaAt(farol_isEmptyPixel(pixel, depth)
  ? 1e9 : -farol_surfacePosition(pixel, depth, farol_size).z);
if (farol_view == 1) gl_FragColor = vec4(vec3(media.a), 1.0);
else {
  gl_FragColor = vec4(media.rgb, 1.0);
#include <tonemapping_fragment>
#include <colorspace_fragment>
}
