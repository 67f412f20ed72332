// Shows one buffer of a deferred frame, as the thesis's figures do.
// Thesis 2.2.3.1, 3.1.1 and 4.1
#include "gbufferRead"
#include "heatMap"
#include "viewport"
uniform highp vec2 farol_size;
uniform highp vec2 thesis_depths; // distances (m) that are shown black and white
uniform highp mat4 thesis_viewInverse;
uniform highp sampler2D thesis_texture; // lighting, or the tiles' depth bounds
uniform highp int thesis_show;
uniform highp float thesis_from; // first pixel column that is shown
uniform highp float thesis_channel; // channel that is shown alone, 0 to 2; -1: all
vec3 thesis_grey(const in float distanceVS) {
  return vec3(log(distanceVS / thesis_depths.x) / log(thesis_depths.y / thesis_depths.x));
}

vec3 thesis_encoded(const in vec3 color) { return linearToOutputTexel(vec4(color, 1.0)).rgb; }
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy - farol_offset);
if (float(pixel.x) < thesis_from) discard;
float depth = farol_gDepthAt(pixel);
vec4 shown = vec4(0.0);
if (thesis_show == 9) {
  vec4 tile = texelFetch(thesis_texture, pixel / 16, 0);
  bool border = (pixel.x & 15) == 0 || (pixel.y & 15) == 0;
  shown.rgb = tile.y > 0.0 ? vec3(thesis_grey(tile.x).r, thesis_grey(tile.y).r, 0.25) : vec3(0.0);
  if (border) shown.rgb *= 0.6;
} else if (thesis_show == 8) shown.rgb = thesis_encoded(texelFetch(thesis_texture, pixel, 0).rgb);
else if (!farol_isEmptyPixel(pixel, depth)) {
  FarolSurface surface = farol_readSurface(pixel, depth, farol_size);
  if (thesis_show == 0) shown.rgb = thesis_encoded(surface.albedo);
  else if (thesis_show == 1) shown.rgb = surface.normalVS * 0.5 + 0.5;
  else if (thesis_show == 2) shown.rgb = thesis_grey(-surface.positionVS.z);
  else if (thesis_show == 3) shown.rgb = fract((thesis_viewInverse * vec4(surface.positionVS, 1.0)).xyz * 0.5);
  else if (thesis_show == 4) shown.rgb = thesis_encoded(surface.material.rgb * surface.material.rgb);
  else if (thesis_show == 5) shown.rgb = vec3(log2(1.0 + surface.accumulation.a) / 8.0);
  else if (thesis_show == 6) shown.rgb = thesis_encoded(surface.accumulation.rgb);
  else if (thesis_show == 7) shown.rgb = farol_heatMap(float(surface.flags & 7) / 3.0);
  else if (thesis_show == 10) {
    // slices of depth, each as thick as the one before it times a factor
    float slice = floor(log2(-surface.positionVS.z / thesis_depths.x) * 3.0);
    shown.rgb = mix(thesis_grey(-surface.positionVS.z), 0.5 + 0.5 * cos(vec3(0.0, 2.1, 4.2) + slice * 1.9), 0.75);
  }
}
if (thesis_channel >= 0.0) shown.rgb = vec3(shown[int(thesis_channel)]);
gl_FragColor = vec4(shown.rgb, 1.0);
