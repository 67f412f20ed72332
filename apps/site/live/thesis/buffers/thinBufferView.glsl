// Shows one buffer of light pre-pass or inferred lighting.
// Thesis 2.2.3.3.2 and 2.2.3.3.3
#include "thinGBufferRead"
#include "viewport"
uniform highp vec2 farol_size;
uniform highp sampler2D farol_sums0;
uniform highp sampler2D farol_sums2;
uniform highp float thesis_scale; // texels of the buffers for each pixel of the picture
uniform highp vec2 thesis_depths; // distances (m) that are shown black and white
uniform highp int thesis_show;
vec3 thesis_encoded(const in vec3 color) { return linearToOutputTexel(vec4(color, 1.0)).rgb; }
//# main
ivec2 texel = ivec2((gl_FragCoord.xy - farol_offset) * thesis_scale);
vec4 surface = texelFetch(farol_thinSurface, texel, 0);
vec3 shown = vec3(0.0);
if (surface.w != 0.0) {
  if (thesis_show == 0) {
    float away = -farol_thinPosition(texel, vec2(textureSize(farol_thinDepth, 0))).z;
    shown = vec3(log(away / thesis_depths.x) / log(thesis_depths.y / thesis_depths.x));
  } else if (thesis_show == 1) shown = farol_decodeNormal(surface.xy) * 0.5 + 0.5;
  else if (thesis_show == 2) shown = vec3(surface.z < 0.0 ? log2(-surface.z) / 8.0 : surface.z);
  else if (thesis_show == 3) shown = 0.5 + 0.5 * cos(vec3(0.0, 2.1, 4.2) + abs(surface.w) * 2.4);
  else if (thesis_show == 4) shown = thesis_encoded(texelFetch(farol_sums0, texel, 0).rgb * 0.3183098862);
  else shown = thesis_encoded(texelFetch(farol_sums2, texel, 0).rgb * 0.1);
}
gl_FragColor = vec4(shown, 1.0);
