// Divergence-free noise field: the cross product of the gradients of two gradient noises, of about unit length.
// DeWolf 2005, Divergence-Free Noise; gradient noise with analytic derivatives: Quilez 2017
vec3 farol_noiseCorner(const in highp ivec3 corner, const in highp uint channel) {
  highp uvec3 v = uvec3(corner) * 1664525u + 1013904223u + channel;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return vec3(v >> 8u) / 8388608.0 - 1.0;
}

vec3 farol_noiseGradient(const in vec3 place, const in highp uint channel) {
  vec3 cell = floor(place);
  ivec3 at = ivec3(cell);
  vec3 f = place - cell;
  vec3 u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  vec3 du = 30.0 * f * f * (f * (f - 2.0) + 1.0);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 8; i++) {
    ivec3 side = ivec3(i & 1, (i >> 1) & 1, i >> 2);
    vec3 far = vec3(side);
    vec3 gradient = farol_noiseCorner(at + side, channel);
    float value = dot(gradient, f - far);
    vec3 w = mix(1.0 - u, u, far);
    vec3 dw = mix(-du, du, far);
    sum += gradient * (w.x * w.y * w.z) + value * vec3(dw.x * w.y * w.z, w.x * dw.y * w.z, w.x * w.y * dw.z);
  }
  return sum;
}

vec3 farol_curlNoise(const in vec3 place) {
  return cross(farol_noiseGradient(place, 0u), farol_noiseGradient(place + 0.37, 7919u));
}
