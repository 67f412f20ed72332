// Noise for surfaces without a texture, equal on every device.
// Jarzynski and Olano 2020, Hash Functions for GPU Rendering (pcg3d); Perlin 1985 (value noise, octaves)
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
// random number of a lattice point, 0 to 1
float farol_random(const in ivec3 cell) {
  return float(farol_hash(uvec3(cell + 65536)).x >> 8u) / 16777216.0;
}
// smooth (value) noise, 0 to 1, on a lattice of spacing 1
float farol_noise(const in vec3 position) {
  vec3 cell = floor(position);
  vec3 t = position - cell;
  t = t * t * (3.0 - 2.0 * t);
  ivec3 i = ivec3(cell);
  vec4 near = vec4(farol_random(i), farol_random(i + ivec3(1, 0, 0)), farol_random(i + ivec3(0, 1, 0)),
    farol_random(i + ivec3(1, 1, 0)));
  vec4 far = vec4(farol_random(i + ivec3(0, 0, 1)), farol_random(i + ivec3(1, 0, 1)),
    farol_random(i + ivec3(0, 1, 1)), farol_random(i + ivec3(1, 1, 1)));
  vec4 z = mix(near, far, t.z);
  vec2 y = mix(z.xy, z.zw, t.y);
  return mix(y.x, y.y, t.x);
}
// sum of four octaves of smooth noise, 0 to 1
float farol_fractalNoise(const in vec3 position) {
  return (8.0 * farol_noise(position) + 4.0 * farol_noise(2.0 * position + 17.0)
    + 2.0 * farol_noise(4.0 * position + 31.0) + farol_noise(8.0 * position + 47.0)) / 15.0;
}
