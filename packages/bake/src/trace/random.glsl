// Low-discrepancy points, also over neighbouring texels together, and directions and positions made from them
// Ahmed and Wonka 2020, Screen-Space Blue-Noise Diffusion of Monte Carlo Sampling Error via Hierarchical Ordering
// of Pixels; Burley 2020, Practical Hash-based Owen Scrambling; Jarzynski and Olano 2020, Hash Functions for GPU
// Rendering
uniform uint farol_seed;
uniform uint farol_stride; // samples per texel, rounded up to a power of 2

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

// three random numbers of a key, from 0 to below 1
vec3 farol_random(const in uvec3 key) {
  return vec3(farol_hash(key) >> 8u) / 16777216.0;
}

uvec2 farol_reversed(uvec2 v) {
  v = v >> 16u | v << 16u;
  v = (v & 0x00ff00ffu) << 8u | (v & 0xff00ff00u) >> 8u;
  v = (v & 0x0f0f0f0fu) << 4u | (v & 0xf0f0f0f0u) >> 4u;
  v = (v & 0x33333333u) << 2u | (v & 0xccccccccu) >> 2u;
  return (v & 0x55555555u) << 1u | (v & 0xaaaaaaaau) >> 1u;
}

// The first two dimensions of the Sobol sequence, with their bits reversed
uvec2 farol_sobol(const in uint index) {
  uint second = 0u;
  uint rest = index;
  for (uint direction = 1u; rest != 0u; rest >>= 1u) {
    if ((rest & 1u) != 0u) second ^= direction;
    direction ^= direction << 1u;
  }
  return uvec2(index, second);
}

// which: index of the sample; stream: different for each use within a sample
vec2 farol_sample2(const in ivec2 texel, const in int which, const in int stream) {
  // texels of a 16 × 16 tile follow a space-filling curve; each has its own range of one sequence
  uvec2 place = uvec2(texel) & 15u;
  place = (place | place << 2u) & 0x33u;
  place = (place | place << 1u) & 0x55u;
  uint index = (place.x | place.y << 1u) * farol_stride + uint(which);
  uvec2 tile = uvec2(texel) >> 4u;
  uvec2 scramble = farol_hash(uvec3(tile.x | tile.y << 16u, farol_seed, uint(stream))).xy;
  uvec2 v = farol_sobol(index);
  v += scramble;
  v ^= v * 0x6c50b47cu;
  v ^= v * 0xb82f1e52u;
  v ^= v * 0xc7afe638u;
  v ^= v * 0x8d22f6e6u;
  return vec2(farol_reversed(v) >> 8u) / 16777216.0;
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

// concentric mapping, so that neighbours in the square are neighbours on the disc
// Shirley and Chiu 1997, A Low Distortion Map Between Disk and Square
vec2 farol_disc(const in vec2 u) {
  vec2 p = 2.0 * u - 1.0;
  bool isFlat = abs(p.x) > abs(p.y);
  float radius = isFlat ? p.x : p.y;
  float angle = 0.78539816 * (isFlat ? p.y / p.x : p.x / (p.y == 0.0 ? 1.0 : p.y));
  vec2 round = isFlat ? vec2(cos(angle), sin(angle)) : vec2(sin(angle), cos(angle));
  return radius * round;
}

// random direction in the hemisphere of a normal, cosine-weighted
vec3 farol_hemisphere(const in vec3 normal, const in vec2 u) {
  vec2 disc = farol_disc(u);
  return farol_basis(normal) * vec3(disc, sqrt(max(0.0, 1.0 - dot(disc, disc))));
}

vec3 farol_sphere(const in vec2 u) {
  float z = 1.0 - 2.0 * u.x;
  float angle = 6.283185307 * u.y;
  return vec3(sqrt(max(0.0, 1.0 - z * z)) * vec2(cos(angle), sin(angle)), z);
}
