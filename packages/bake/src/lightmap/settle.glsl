// Moves a texel's point out of what it lies in and away from corners, and finds texels that see backs of surfaces: they
// are filled by their neighbours
// Gribble 2019, Baking artifact-free lightmaps
#include "tables"
#include "random"
#include "traverse"
uniform highp sampler2D farol_positions;
uniform highp sampler2D farol_faces;
uniform float farol_offset;
uniform float farol_texelSize; // m
layout(location = 0) out highp vec4 farol_settled;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  farol_settled = texelFetch(farol_positions, texel, 0);
  if (farol_settled.w <= 0.0) return;
  vec3 face = texelFetch(farol_faces, texel, 0).xyz;
  mat3 basis = farol_basis(face);
  vec3 origin = farol_settled.xyz + farol_offset * face;
  // charts begin at centres of texels, which then lie right in the corner between two surfaces
  float least = 0.25 * farol_texelSize;
  float before = 0.2 * farol_texelSize;
  for (int i = 0; i < 4; i++) {
    vec3 along = (i < 2 ? basis[0] : basis[1]) * ((i & 1) == 0 ? 1.0 : -1.0);
    FarolHit hit = farol_trace(origin - before * along, along, before + 0.75 * farol_texelSize, false);
    if (hit.triangle < 0) continue;
    float ahead = hit.distance - before;
    // beyond a surface whose back is met, before one whose front is
    if (!farol_hitShines(hit)) farol_settled.xyz += (ahead + least) * along;
    else if (ahead < least) farol_settled.xyz += (ahead - least) * along;
    origin = farol_settled.xyz + farol_offset * face;
  }
  int backs = 0;
  for (int i = 0; i < 24; i++) {
    FarolHit hit = farol_trace(origin, farol_hemisphere(face, farol_sample2(texel, i, 4)), 1e30, false);
    if (hit.triangle >= 0 && !farol_hitShines(hit)) backs++;
  }
  if (backs > 12) farol_settled.w = -1.0;
}
