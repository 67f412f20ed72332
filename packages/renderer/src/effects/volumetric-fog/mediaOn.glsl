// Light on its way to the eye through fog, from the integrated froxels; replaces media once VolumetricFog is used.
// Wronski 2014, Volumetric Fog: Unified Compute Shader Based Solution to Atmospheric Scattering (SIGGRAPH)
uniform highp sampler3D farol_media; // rgb: light scattered to the eye up to the end of each slice; a: transmittance
// [0]: first pixel, 1 / size of the picture; [1]: slices' 1 / scale (1/m), 1 / exponent, number; 1 if there is fog
uniform highp vec4 farol_mediaSpace[2];

// fog between the eye and a depth (m, along the view) in this pixel: scattered radiance, transmittance
vec4 farol_mediaAt(const in float depth) {
  vec4 slices = farol_mediaSpace[1];
  if (slices.w == 0.0) return vec4(0.0, 0.0, 0.0, 1.0);
  float passed = min(log(1.0 + max(depth, 0.0) * slices.x) * slices.y, 1.0) * slices.z;
  vec2 uv = (gl_FragCoord.xy - farol_mediaSpace[0].xy) * farol_mediaSpace[0].zw;
  vec4 media = texture(farol_media, vec3(uv, (max(passed, 1.0) - 0.5) / slices.z));
  return mix(vec4(0.0, 0.0, 0.0, 1.0), media, min(passed, 1.0));
}

vec3 farol_throughMedia(const in vec3 radiance, const in float depth) {
  vec4 media = farol_mediaAt(depth);
  return radiance * media.a + media.rgb;
}

// removes the fog between the eye and this pixel's depth (a glass's) from the light of a surface behind it
vec4 farol_behindMedia(const in vec4 fogged) {
  vec4 media = farol_mediaAt(1.0 / gl_FragCoord.w);
  return vec4(max(vec3(0.0), fogged.rgb - media.rgb) / max(media.a, 0.05), fogged.a);
}
