// Indirect light on a white surface by world-space normal: second-order spherical harmonics, from nine normals.
// Ramamoorthi and Hanrahan 2001, An Efficient Representation for Irradiance Environment Maps
uniform highp sampler2D farol_surroundings; // irradiance of nine normals: +X, -X, +Y, -Y, +Z, -Z, YZ, ZX, XY

vec3 farol_surroundingLight(const in vec3 normal) {
  vec3 sum = vec3(0.0);
  vec3 between[3]; // light for normals half way between two axes
  for (int i = 0; i < 3; i++) {
    vec3 more = texelFetch(farol_surroundings, ivec2(2 * i, 0), 0).rgb;
    vec3 less = texelFetch(farol_surroundings, ivec2(2 * i + 1, 0), 0).rgb;
    sum += 0.5 * normal[i] * ((normal[i] + 1.0) * more + (normal[i] - 1.0) * less);
    between[i] = 0.60355339 * more - 0.10355339 * less;
  }
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    vec3 found = texelFetch(farol_surroundings, ivec2(6 + i, 0), 0).rgb;
    sum += 2.0 * normal[j] * normal[k] * (found - between[j] - between[k]);
  }
  return max(sum, vec3(0.0));
}
