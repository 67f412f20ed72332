// Moves a texel's point out of solids and away from corners, and marks texels that see back faces, which are filled
// from their neighbours
// Gribble 2019, Baking artifact-free lightmaps
#include "tables"
#include "random"
#include "traverse"
uniform highp sampler2D farol_places;
uniform highp sampler2D farol_faces;
uniform float farol_offset;
uniform float farol_texelSize; // side of a texel (m)
layout(location = 0) out highp vec4 farol_moved;

int farol_backs(const in ivec2 texel, const in vec3 origin, const in vec3 face, const in int first, const in int end) {
  int backs = 0;
  for (int i = first; i < end; i++) {
    FarolHit hit = farol_trace(origin, farol_hemisphere(face, farol_sample2(texel, i, 4)), 1e30);
    if (hit.triangle >= 0 && !farol_hitShines(hit)) backs++;
  }
  return backs;
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 place = texelFetch(farol_places, texel, 0);
  farol_moved = vec4(0.0);
  if (place.w <= 0.0) return;
  vec3 face = texelFetch(farol_faces, texel, 0).xyz;
  mat3 basis = farol_basis(face);
  vec3 start = place.xyz + farol_offset * face;
  vec3 origin = start;
  // charts begin at texel centres, which may lie exactly in the corner between two surfaces
  float least = 0.25 * farol_texelSize;
  float before = 0.2 * farol_texelSize;
  for (int i = 0; i < 4; i++) {
    vec3 along = (i < 2 ? basis[0] : basis[1]) * ((i & 1) == 0 ? 1.0 : -1.0);
    FarolHit hit = farol_trace(origin - before * along, along, before + 0.75 * farol_texelSize);
    if (hit.triangle < 0) continue;
    float ahead = hit.distance - before;
    // moves beyond a back face, or back in front of a front face
    if (!farol_hitShines(hit)) origin += (ahead + least) * along;
    else if (ahead < least) origin += (ahead - least) * along;
  }
  // for most texels no ray hits a back face
  int backs = farol_backs(texel, origin, face, 0, 8);
  if (backs > 0) backs += farol_backs(texel, origin, face, 8, 24);
  farol_moved = vec4(origin - start, backs > 12 ? -1.0 : 1.0);
}
