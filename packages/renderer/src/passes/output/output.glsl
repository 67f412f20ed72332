// Writes linear radiance and depth to the host's target as three would: tone mapped, encoded, fogged, then dithered.
// three's opaque_fragment, tonemapping_fragment, colorspace_fragment, fog_fragment, dithering_fragment
#include "media"
#include "viewport"
uniform vec4 farol_background; // colour of empty pixels; a below 0: do not write them
#ifdef USE_FOG
uniform vec3 fogColor;
#ifdef FOG_EXP2
uniform float fogDensity;
#else
uniform float fogNear;
uniform float fogFar;
#endif
#endif

vec4 farol_output(const in vec3 radiance, const in float fogDepth, const in bool toneMapped, const in bool fogged,
  const in bool dithered) {
  vec3 arriving = fogged ? farol_throughMedia(radiance, fogDepth) : radiance;
  vec4 color = vec4(min(arriving, 1e9), 1.0); // infinite radiance would become NaN in later arithmetic
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
  if (dithered) {
    float turn = mod(dot(gl_FragCoord.xy, vec2(12.9898, 78.233)), 3.141592653589793);
    color.rgb += (0.5 - fract(sin(turn) * 43758.5453)) / 255.0 * vec3(1.0, -1.0, 1.0);
  }
  return color;
}
