// Writes linear radiance and depth to the host's target as three would: tone mapping, colour space, then fog.
// three's opaque_fragment, tonemapping_fragment, colorspace_fragment, fog_fragment
#include "viewport"
uniform vec4 farol_background; // what the target would have been cleared to; a below 0: it has been, or is to be kept
#ifdef USE_FOG
uniform vec3 fogColor;
#ifdef FOG_EXP2
uniform float fogDensity;
#else
uniform float fogNear;
uniform float fogFar;
#endif
#endif

vec4 farol_output(const in vec3 radiance, const in float fogDepth, const in bool toneMapped, const in bool fogged) {
  vec4 color = vec4(min(radiance, 1e9), 1.0); // infinity, beyond half floats, would become no number
#ifdef TONE_MAPPING
  if (toneMapped) color.rgb = toneMapping(color.rgb);
#endif
  color = linearToOutputTexel(color);
#ifdef USE_FOG
  if (fogged) {
#ifdef FOG_EXP2
    float fogFactor = 1.0 - exp(-fogDensity * fogDensity * fogDepth * fogDepth);
#else
    float fogFactor = smoothstep(fogNear, fogFar, fogDepth);
#endif
    color.rgb = mix(color.rgb, fogColor, fogFactor);
  }
#endif
  return color;
}
