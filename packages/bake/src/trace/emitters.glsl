// Light of emissive surfaces, by a point on them that is chosen in proportion to power
// Veach 1997, Robust Monte Carlo Methods for Light Transport Simulation, 9.2
uniform highp sampler2D farol_emitters; // for each emissive triangle: cumulated share of all power, index
uniform int farol_emitterCount;
uniform float farol_emitterPower; // sum of luminance × area over all emissive triangles
uniform highp sampler2DArray farol_emission;

// probability density (per solid angle) of choosing a point of a triangle. range: index of its range in farol_ranges
float farol_emitterChance(const in int range, const in float distance, const in float facing) {
  float luminance = farol_table(farol_ranges, 2 * range + 1).z;
  return luminance / farol_emitterPower * distance * distance / max(facing, 1e-6);
}

vec3 farol_emitterLight(const in vec3 origin, const in vec3 normal, const in ivec2 texel, const in int which) {
  vec2 u = farol_sample2(texel, which, 2);
  int low = 0;
  int high = farol_emitterCount - 1;
  while (low < high) {
    int middle = (low + high) / 2;
    if (farol_table(farol_emitters, middle).x > u.x) high = middle;
    else low = middle + 1;
  }
  int triangle = int(farol_table(farol_emitters, low).y);
  // the position within the chosen triangle's share is a random number too
  float before = low > 0 ? farol_table(farol_emitters, low - 1).x : 0.0;
  u.x = clamp((u.x - before) / max(farol_table(farol_emitters, low).x - before, 1e-9), 0.0, 1.0);
  float root = sqrt(u.x);
  vec2 barycentric = vec2(root * (1.0 - u.y), root * u.y);
  vec4 corner = farol_table(farol_triangles, 3 * triangle);
  vec3 edge1 = farol_table(farol_triangles, 3 * triangle + 1).xyz;
  vec3 edge2 = farol_table(farol_triangles, 3 * triangle + 2).xyz;
  vec3 path = corner.xyz + barycentric.x * edge1 + barycentric.y * edge2 - origin;
  float distance = length(path);
  vec3 along = path / distance;
  vec3 face = normalize(cross(edge1, edge2));
  FarolHit hit = FarolHit(distance, triangle, int(corner.w), barycentric, dot(face, along) < 0.0);
  float cosine = dot(normal, along);
  if (cosine <= 0.0 || !farol_hitShines(hit)) return vec3(0.0);
  float byCosine = cosine * 0.31830989;
  float byPower = farol_emitterChance(hit.range, distance, abs(dot(face, along)));
  float through = farol_transmittance(origin, along, 0.9999 * distance);
  return through * textureLod(farol_emission, farol_hitPlace(hit), 0.0).rgb * byCosine / (byCosine + byPower);
}
