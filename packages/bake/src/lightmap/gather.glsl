// Light at each texel from surfaces hit by rays into the hemisphere. Sums over samples: irradiance / pi and squared
// luminance; luminance of the part that comes from sky and emissive surfaces, not from lights
// Kajiya 1986, The Rendering Equation
#include "tables"
#include "random"
#include "traverse"
#include "sky"
uniform highp sampler2D farol_positions;
uniform highp sampler2D farol_texelNormals;
uniform highp sampler2D farol_faces;
uniform highp sampler2DArray farol_radiance; // rgb: radiance; a: luminance of its part from sky and emissive surfaces
uniform int farol_firstSample;
uniform float farol_offset;
#include "emitters"
layout(location = 0) out highp vec4 farol_sum;
layout(location = 1) out highp vec4 farol_sourceSum;

float farol_luminance(const in vec3 colour) {
  return dot(colour, vec3(0.2126, 0.7152, 0.0722));
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 place = texelFetch(farol_positions, texel, 0);
  if (place.w <= 0.0) discard;
  vec3 normal = normalize(texelFetch(farol_texelNormals, texel, 0).xyz);
  vec3 face = texelFetch(farol_faces, texel, 0).xyz;
  vec3 origin = place.xyz + farol_offset * face;
  farol_sum = farol_sourceSum = vec4(0.0);
  for (int i = 0; i < SAMPLES; i++) {
    int which = farol_firstSample + i;
    vec3 along = farol_hemisphere(normal, farol_sample2(texel, which, 1));
    // an interpolated normal may differ from the face's: rays must still start on the front of the face
    float height = dot(along, face);
    if (height < 0.0) along -= 2.0 * height * face;
    vec3 light = vec3(0.0);
    float sources = 0.0;
    FarolHit hit = farol_trace(origin, along, 1e30);
    vec3 at = hit.triangle >= 0 && farol_hitShines(hit) ? farol_hitPlace(hit) : vec3(-1.0);
#ifdef FROM_SOURCES
    if (hit.triangle < 0) light = farol_sky(along);
    else if (farol_emitterCount > 0 && at.z >= 0.0) {
      light = textureLod(farol_emission, at, 0.0).rgb;
      vec3 edge1 = farol_table(farol_triangles, 3 * hit.triangle + 1).xyz;
      vec3 edge2 = farol_table(farol_triangles, 3 * hit.triangle + 2).xyz;
      float byCosine = max(dot(normal, along), 1e-4) * 0.31830989;
      float byPower = farol_emitterChance(hit.range, hit.distance, abs(dot(normalize(cross(edge1, edge2)), along)));
      light *= byCosine / (byCosine + byPower);
    }
    if (farol_emitterCount > 0) light += farol_emitterLight(origin, normal, texel, which);
    sources = farol_luminance(light);
#endif
#ifdef REFLECTED
    if (at.z >= 0.0) {
      vec4 radiance = textureLod(farol_radiance, at, 0.0);
#ifdef SOURCES_ALONE
      radiance.rgb *= clamp(radiance.a / max(farol_luminance(radiance.rgb), 1e-12), 0.0, 1.0);
#endif
      light += radiance.rgb;
      sources += radiance.a;
    }
#endif
    float luminance = farol_luminance(light);
    farol_sum += vec4(light, luminance * luminance);
    farol_sourceSum.r += sources;
  }
}
