// Low-discrepancy points, shifted by texel, and directions and places made of them
// Roberts 2018, Effectiveness of Quasirandom Sequences; Jarzynski and Olano 2020, Hash Functions for GPU Rendering
uniform uint farol_seed;

uvec3 farol_hash(uvec3 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return v;
}

// 0 to 1, without 1
vec3 farol_random(const in uvec3 key) {
  return vec3(farol_hash(key) >> 8u) / 16777216.0;
}

// which: number of the sample; stream: apart for each use in a sample
vec2 farol_sample2(const in ivec2 texel, const in int which, const in int stream) {
  vec2 shift = farol_random(uvec3(uint(texel.x) | uint(texel.y) << 16u, farol_seed, uint(stream))).xy;
  // the sequence in whole numbers: floats would lose its fine steps after thousands of samples
  uvec2 steps = uvec2(uint(which)) * uvec2(3242174889u, 2447445414u);
  return fract(shift + vec2(steps >> 8u) / 16777216.0);
}

mat3 farol_basis(const in vec3 normal) {
  float s = normal.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (s + normal.z);
  float b = normal.x * normal.y * a;
  return mat3(
    vec3(1.0 + s * normal.x * normal.x * a, s * b, -s * normal.x),
    vec3(b, s + normal.y * normal.y * a, -normal.y),
    normal
  );
}

vec2 farol_disc(const in vec2 u) {
  float radius = sqrt(u.x);
  float angle = 6.283185307 * u.y;
  return radius * vec2(cos(angle), sin(angle));
}

// by the cosine to the normal
vec3 farol_hemisphere(const in vec3 normal, const in vec2 u) {
  vec2 disc = farol_disc(u);
  return farol_basis(normal) * vec3(disc, sqrt(max(0.0, 1.0 - u.x)));
}

vec3 farol_sphere(const in vec2 u) {
  float z = 1.0 - 2.0 * u.x;
  float angle = 6.283185307 * u.y;
  return vec3(sqrt(max(0.0, 1.0 - z * z)) * vec2(cos(angle), sin(angle)), z);
}
