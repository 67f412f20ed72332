// Traverses the bounding volume hierarchy along a ray: finds the nearest triangle, or the share of light that passes
// Aila and Laine 2009, Understanding the Efficiency of Ray Traversal on GPUs; Möller and Trumbore 1997
uniform highp sampler2D farol_nodes;
uniform highp sampler2D farol_triangles; // three texels per triangle: (corner, range), (edge, index), (edge, 0)
uniform highp sampler2D farol_corners; // a texel per corner of a triangle: xy: lightmap UV; zw: UV of maps
uniform highp sampler2D farol_ranges; // table of ranges of triangles, two texels each, see rangesTable
uniform highp sampler2DArray farol_opacity;

struct FarolHit {
  float distance; // distance of the hit (m); 1e30 for none
  int triangle;
  int range;
  vec2 barycentric; // barycentric weights of the second and third corner
  bool isFront;
};

float farol_boxDistance(const in vec4 least, const in vec4 greatest, const in vec3 origin, const in vec3 inverse,
  const in float most) {
  vec3 low = (least.xyz - origin) * inverse;
  vec3 high = (greatest.xyz - origin) * inverse;
  vec3 near = min(low, high);
  vec3 far = max(low, high);
  float enter = max(max(near.x, near.y), max(near.z, 0.0));
  float leave = min(min(far.x, far.y), min(far.z, most));
  return enter <= leave * 1.0000004 ? enter : 1e30;
}

// opacity of a surface at a hit: the share of rays that it stops
float farol_opacityAt(const in int triangle, const in int range, const in vec2 barycentric) {
  vec4 surface = farol_table(farol_ranges, 2 * range);
  if (surface.z == 0.0) return 1.0; // an opaque material stops every ray
  float opacity = surface.w;
  if (surface.y >= 0.0) {
    vec2 uv = (1.0 - barycentric.x - barycentric.y) * farol_table(farol_corners, 3 * triangle).zw;
    uv += barycentric.x * farol_table(farol_corners, 3 * triangle + 1).zw;
    uv += barycentric.y * farol_table(farol_corners, 3 * triangle + 2).zw;
    opacity *= textureLod(farol_opacity, vec3(uv, surface.y), 0.0).r;
  }
  if (surface.z > 0.0) return opacity < surface.z ? 0.0 : 1.0; // alphaTest: a texel stops all rays or none
  return clamp(opacity, 0.0, 1.0);
}

// most: greatest distance; shadow: stops when no light passes; through: share of light that passes
FarolHit farol_walk(const in vec3 origin, const in vec3 direction, const in float most, const in bool shadow,
  out float through) {
  FarolHit hit = FarolHit(1e30, -1, -1, vec2(0.0), true);
  through = 1.0;
  float nearest = most;
  float before = -1.0; // distance of the last triangle hit
  vec3 safe = vec3(
    abs(direction.x) > 1e-12 ? direction.x : 1e-12,
    abs(direction.y) > 1e-12 ? direction.y : 1e-12,
    abs(direction.z) > 1e-12 ? direction.z : 1e-12
  );
  vec3 inverse = 1.0 / safe;
  int stack[BVH_DEPTH + 2];
  int top = 0;
  int node = 0;
  while (node >= 0) {
    vec4 leftLeast = farol_table(farol_nodes, 4 * node);
    vec4 leftGreatest = farol_table(farol_nodes, 4 * node + 1);
    vec4 rightLeast = farol_table(farol_nodes, 4 * node + 2);
    vec4 rightGreatest = farol_table(farol_nodes, 4 * node + 3);
    float left = farol_boxDistance(leftLeast, leftGreatest, origin, inverse, nearest);
    float right = farol_boxDistance(rightLeast, rightGreatest, origin, inverse, nearest);
    ivec2 leaf = ivec2(-1, 0); // first triangle and count: of the left child, then of the right one
    ivec2 other = ivec2(-1, 0);
    if (left < 1e30 && leftGreatest.w > 0.0) leaf = ivec2(leftLeast.w, leftGreatest.w);
    if (right < 1e30 && rightGreatest.w > 0.0) other = ivec2(rightLeast.w, rightGreatest.w);
    for (int child = 0; child < 2; child++) {
      for (int i = 0; i < leaf.y; i++) {
        int triangle = leaf.x + i;
        vec4 corner = farol_table(farol_triangles, 3 * triangle);
        vec4 edge1 = farol_table(farol_triangles, 3 * triangle + 1);
        vec4 edge2 = farol_table(farol_triangles, 3 * triangle + 2);
        vec3 p = cross(direction, edge2.xyz);
        float determinant = dot(edge1.xyz, p);
        float factor = 1.0 / determinant;
        vec3 t = origin - corner.xyz;
        float u = dot(t, p) * factor;
        vec3 q = cross(t, edge1.xyz);
        float v = dot(direction, q) * factor;
        float distance = dot(edge2.xyz, q) * factor;
        // false for NaN
        bool isMet = u >= -1e-6 && v >= -1e-6 && u + v <= 1.000001 && distance > 0.0 && distance < nearest;
        if (!isMet) continue;
        int range = int(corner.w);
        vec2 barycentric = vec2(u, v);
        if (shadow && farol_table(farol_ranges, 2 * range + 1).y > 0.0) continue; // the range casts no shadow
        float opacity = farol_opacityAt(triangle, range, barycentric);
        if (shadow) {
          // two triangles hit at their common edge count as one surface
          if (abs(distance - before) <= 1e-6 * distance) continue;
          if (opacity > 0.0) before = distance;
          through *= 1.0 - opacity;
          if (through < 1e-3) {
            through = 0.0;
            return hit;
          }
          continue;
        }
        // random number that decides whether the ray stops
        uvec3 key = floatBitsToUint(origin + direction) + uint(triangle);
        if (opacity < 1.0 && farol_random(key).x >= opacity) continue;
        nearest = distance;
        hit = FarolHit(distance, triangle, range, barycentric, determinant > 0.0);
      }
      leaf = other;
    }
    int first = left < 1e30 && leftGreatest.w == 0.0 ? int(leftLeast.w) : -1;
    int second = right < 1e30 && rightGreatest.w == 0.0 ? int(rightLeast.w) : -1;
    if (first >= 0 && second >= 0) {
      bool swap = right < left;
      stack[top++] = swap ? first : second;
      node = swap ? second : first;
    } else {
      node = max(first, second);
      if (node < 0 && top > 0) node = stack[--top];
    }
  }
  return hit;
}

// nearest hit of a ray with the scene
FarolHit farol_trace(const in vec3 origin, const in vec3 direction, const in float most) {
  float through;
  return farol_walk(origin, direction, most, false, through);
}

// share of light that the surfaces along a ray let pass
float farol_transmittance(const in vec3 origin, const in vec3 direction, const in float most) {
  float through;
  farol_walk(origin, direction, most, true, through);
  return through;
}

// lightmap UV and layer of a hit; layer -1 for none
vec3 farol_hitPlace(const in FarolHit hit) {
  float layer = farol_table(farol_ranges, 2 * hit.range).x;
  vec2 uv = (1.0 - hit.barycentric.x - hit.barycentric.y) * farol_table(farol_corners, 3 * hit.triangle).xy;
  uv += hit.barycentric.x * farol_table(farol_corners, 3 * hit.triangle + 1).xy;
  uv += hit.barycentric.y * farol_table(farol_corners, 3 * hit.triangle + 2).xy;
  return vec3(uv, layer);
}

// whether the side of a surface that was hit receives and emits light
bool farol_hitShines(const in FarolHit hit) {
  return hit.isFront || farol_table(farol_ranges, 2 * hit.range + 1).x > 0.0;
}
