// Irradiance at each texel by the lights of a table with soft shadows, or by those with hard ones: sum over samples,
// and sum of squared luminance
// three.js, lights_fragment_begin
#include "tables"
#include "random"
#include "traverse"
#include "lightTable"
uniform highp sampler2D farol_positions;
uniform highp sampler2D farol_texelNormals;
uniform highp sampler2D farol_faces;
uniform highp sampler2D farol_agreements;
uniform int farol_firstSample;
uniform float farol_offset;
layout(location = 0) out highp vec4 farol_sum;
layout(location = 1) out highp vec4 farol_sourceSum; // always 0: only gathers count light of emissive surfaces and sky

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 place = texelFetch(farol_positions, texel, 0);
  if (place.w <= 0.0) discard;
  if (farol_firstSample > 0 && texelFetch(farol_agreements, texel, 0).r > 0.5) discard;
  vec3 normal = normalize(texelFetch(farol_texelNormals, texel, 0).xyz);
  vec3 origin = place.xyz + farol_offset * texelFetch(farol_faces, texel, 0).xyz;
  farol_sum = farol_sourceSum = vec4(0.0);
  ivec2 list = farol_lightList(place.xyz);
  for (int i = 0; i < SAMPLES; i++) {
    vec3 light = vec3(0.0);
    for (int l = 0; l < farol_endlessLights + list.y; l++) {
      int which = farol_listedLight(list, l);
      if (farol_isSoft(which) != SOFT) continue;
      vec2 u = farol_sample2(texel, farol_firstSample + i, 16 + which);
      light += farol_unshadowed(farol_arrival(which, place.xyz, normal, u), place.xyz, origin);
    }
    float luminance = dot(light, vec3(0.2126, 0.7152, 0.0722));
    farol_sum += vec4(light, luminance * luminance);
  }
}
