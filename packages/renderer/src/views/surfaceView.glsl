// Shows one property of the G-buffer.
// Thesis 4.1, figure of the G-buffer
#include "gbufferRead"
#include "viewport"
uniform vec2 farol_size;
uniform vec3 farol_depthRange; // x, y: distances shown black and white (m); z: 1 for a logarithmic scale
uniform mat4 farol_viewInverse;
uniform int farol_view; // 0 albedo, 1 normal, 2 depth, 3 position, 4 roughness, 5 metalness, 6 emissive
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy - farol_offset);
float depth = farol_gDepthAt(pixel);
gl_FragColor = vec4(0.0, 0.0, 0.0, 1.0);
if (!farol_isEmptyPixel(pixel, depth)) {
  FarolSurface surface = farol_readSurface(pixel, depth, farol_size);
  int model = farol_shadingModel(surface.flags);
  if (farol_view == 0) gl_FragColor = linearToOutputTexel(vec4(surface.albedo, 1.0));
  else if (farol_view == 1) gl_FragColor.rgb = model == 0 ? vec3(0.5) : surface.normalVS * 0.5 + 0.5;
  else if (farol_view == 2) {
    float distanceVS = -surface.positionVS.z;
    gl_FragColor.rgb = vec3(farol_depthRange.z > 0.0
      ? log(distanceVS / farol_depthRange.x) / log(farol_depthRange.y / farol_depthRange.x)
      : (distanceVS - farol_depthRange.x) / (farol_depthRange.y - farol_depthRange.x));
  } else if (farol_view == 3) {
    // one metre is a tenth of the colour's range, so that walls show a grid of ten metres
    gl_FragColor.rgb = fract((farol_viewInverse * vec4(surface.positionVS, 1.0)).xyz * 0.1);
  } else if (farol_view == 4) {
    // Blinn-Phong's roughness from shininess: alpha² = 2 / (shininess + 2)
    gl_FragColor.rgb = vec3(model == 1 ? surface.material.r
      : model == 2 ? sqrt(sqrt(2.0 / (surface.accumulation.a + 2.0))) : 1.0);
  } else if (farol_view == 5) gl_FragColor.rgb = vec3(model == 1 ? surface.material.g : 0.0);
  else gl_FragColor = linearToOutputTexel(vec4(surface.accumulation.rgb, 1.0));
}
