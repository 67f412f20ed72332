// Irradiance of a surface from a grid of light probes: spherical harmonics of second order in cells of a box.
// Ramamoorthi and Hanrahan, An Efficient Representation for Irradiance Environment Maps, 2001
uniform highp sampler3D farol_probes; // probes' spherical harmonics, laid out as in effects/light-probes/ProbeGrid.ts
uniform vec3 farol_probesMin, farol_probesMax; // corners of the grid's box (m, world space)
uniform vec3 farol_probeCounts;
uniform float farol_environmentShare; // factor of environment light: 0 if the probes hold it, else 1

vec3 farol_probeIrradiance(const in vec3 positionVS, const in vec3 normalVS) {
  vec3 position = ((vec4(positionVS, 1.0) - viewMatrix[3]) * viewMatrix).xyz;
  vec3 n = (vec4(normalVS, 0.0) * viewMatrix).xyz;
  vec3 size = farol_probesMax - farol_probesMin;
  // sampled half a cell off the surface, so that light from behind a wall does not leak
  vec3 at = (position + n * (0.5 * size / farol_probeCounts) - farol_probesMin) / size;
  at = clamp(at, 0.5 / farol_probeCounts, 1.0 - 0.5 / farol_probeCounts);
  float slices = farol_probeCounts.z + 2.0;
  float z = (at.z * farol_probeCounts.z + 1.0) / (7.0 * slices);
  const float volume = 1.0 / 7.0;
  vec4 s0 = texture(farol_probes, vec3(at.xy, z));
  vec4 s1 = texture(farol_probes, vec3(at.xy, z + volume));
  vec4 s2 = texture(farol_probes, vec3(at.xy, z + 2.0 * volume));
  vec4 s3 = texture(farol_probes, vec3(at.xy, z + 3.0 * volume));
  vec4 s4 = texture(farol_probes, vec3(at.xy, z + 4.0 * volume));
  vec4 s5 = texture(farol_probes, vec3(at.xy, z + 5.0 * volume));
  vec4 s6 = texture(farol_probes, vec3(at.xy, z + 6.0 * volume));
  vec3 sum = 0.886227 * s0.xyz;
  sum += 1.023328 * (vec3(s0.w, s1.xy) * n.y + vec3(s1.zw, s2.x) * n.z + s2.yzw * n.x);
  sum += 0.858086 * (s3.xyz * (n.x * n.y) + vec3(s3.w, s4.xy) * (n.y * n.z) + s5.yzw * (n.x * n.z));
  sum += vec3(s4.zw, s5.x) * (0.743125 * n.z * n.z - 0.247708);
  sum += 0.429043 * s6.xyz * (n.x * n.x - n.y * n.y);
  return max(sum, vec3(0.0));
}
