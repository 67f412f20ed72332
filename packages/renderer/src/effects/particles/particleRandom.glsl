// Three random numbers of 24 bits, from 0 to below 1, hashed from a particle's number, a channel and the seed.
// Jarzynski and Olano 2020, Hash Functions for GPU Rendering, https://jcgt.org/published/0009/03/02/ (pcg3d)
uniform highp uint farol_particleSeed;

vec3 farol_particleRandom(const in highp uint number, const in highp uint channel) {
  highp uvec3 v = uvec3(number, channel, farol_particleSeed) * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return vec3(v >> 8u) / 16777216.0;
}
