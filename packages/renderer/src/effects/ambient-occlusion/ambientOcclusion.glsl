// Horizon-based ambient occlusion; red: open share of the sky, weighted by the cosine; green: the surface's view z.
// Jimenez et al. 2016, Practical Real-Time Strategies for Accurate Indirect Occlusion (GTAO)
#include "occlusionSurface"
#include "octahedralNormal"
#ifdef FAROL_NORMALS
uniform highp sampler2D farol_surfaceNormal; // normal of the surface: view space, octahedral
#endif
uniform highp vec4 farol_reach; // x: radius (m); y: radius at 1 m (pixels); w: its maximum (pixels); z: pixels a texel
layout(location = 0) out highp vec4 farol_open;

const int FAROL_SLICES = 3;
const int FAROL_STEPS = 5;

vec3 farol_positionAt(const in ivec2 pixel) {
  ivec2 size = ivec2(farol_frameSize);
  ivec2 at = clamp(pixel, ivec2(0), size - 1);
  return farol_unprojectAt((vec2(at) + 0.5) / vec2(size), farol_surfaceZ(at));
}

bool farol_isInside(const in ivec2 pixel) {
  return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, ivec2(farol_frameSize)));
}

// change of the view-space position (m) from a pixel to the next, on the side where depth changes less
vec3 farol_change(const in ivec2 pixel, const in vec3 position, const in ivec2 to) {
  vec3 after = farol_positionAt(pixel + to) - position;
  vec3 before = position - farol_positionAt(pixel - to);
  if (!farol_isInside(pixel + to)) return before;
  if (!farol_isInside(pixel - to)) return after;
  return abs(after.z) < abs(before.z) ? after : before;
}

vec3 farol_normalAt(const in ivec2 pixel, const in vec3 position) {
#ifdef FAROL_NORMALS
  vec3 normal = farol_decodeNormal(texelFetch(farol_surfaceNormal, pixel, 0).xy);
  if (normal != vec3(0.0)) return normal;
#endif
  return normalize(cross(farol_change(pixel, position, ivec2(1, 0)), farol_change(pixel, position, ivec2(0, 1))));
}

// cosine of the highest horizon along a direction on screen, as seen from the position
float farol_horizon(const in ivec2 pixel, const in vec3 position, const in vec3 toEye, const in vec2 direction,
  const in float radius, const in float shift, const in float lowest) {
  float highest = lowest;
  for (int i = 0; i < FAROL_STEPS; i++) {
    float part = (float(i) + shift) / float(FAROL_STEPS);
    ivec2 offset = ivec2(round(direction * max(part * part * radius, float(i) + 1.0)));
    if (!farol_isInside(pixel + offset)) break;
    vec3 there = farol_positionAt(pixel + offset) - position;
    float distanceSquared = dot(there, there);
    float cosine = dot(there, toEye) * inversesqrt(max(distanceSquared, 1e-12));
    // a sample's weight falls to 0 at the radius
    float weight = clamp(2.0 - 2.0 * distanceSquared / (farol_reach.x * farol_reach.x), 0.0, 1.0);
    highest = max(highest, mix(lowest, cosine, weight));
  }
  return highest;
}
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy) * int(farol_reach.z);
pixel = min(pixel, ivec2(farol_frameSize) - 1);
float depth = texelFetch(farol_surfaceDepth, pixel, 0).r;
farol_open = vec4(1.0, 0.0, 0.0, 1.0);
if (!farol_isEmpty(depth)) {
  vec3 position = farol_positionAt(pixel);
  farol_open.g = position.z;
  float radius = min(farol_perspective == 0.0 ? farol_reach.y : farol_reach.y / -position.z, farol_reach.w);
  if (radius > 1.0) {
    vec3 toEye = farol_perspective == 0.0 ? vec3(0.0, 0.0, 1.0) : normalize(-position);
    vec3 normal = farol_normalAt(pixel, position);
    ivec2 cell = ivec2(gl_FragCoord.xy) & 3;
    // the samples of each 4 × 4 texels have 16 rotations and 4 offsets, which occlusionFilter.glsl averages
    float turn = float((((cell.x + cell.y) & 3) << 2) + cell.x) / 16.0;
    float shift = 0.25 + 0.25 * float((cell.y - cell.x) & 3);
    float open = 0.0;
    for (int i = 0; i < FAROL_SLICES; i++) {
      float angle = 3.14159265 * (float(i) + turn) / float(FAROL_SLICES);
      vec2 direction = vec2(cos(angle), sin(angle));
      vec3 inPlane = vec3(direction, 0.0) - dot(vec3(direction, 0.0), toEye) * toEye;
      vec3 axis = normalize(cross(vec3(direction, 0.0), toEye));
      vec3 projected = normal - axis * dot(normal, axis);
      float size = length(projected);
      float cosine = clamp(dot(projected, toEye) / max(size, 1e-6), -1.0, 1.0);
      float n = sign(dot(inPlane, projected)) * acos(cosine);
      float ahead = farol_horizon(pixel, position, toEye, direction, radius, shift,
        cos(min(n + 1.57079633, 3.14159265)));
      float behind = farol_horizon(pixel, position, toEye, -direction, radius, shift,
        cos(max(n - 1.57079633, -3.14159265)));
      float h1 = n + clamp(acos(clamp(ahead, -1.0, 1.0)) - n, -1.57079633, 1.57079633);
      float h0 = n + clamp(-acos(clamp(behind, -1.0, 1.0)) - n, -1.57079633, 1.57079633);
      open += size * 0.25 * (2.0 * cosine + 2.0 * (h0 + h1) * sin(n) - cos(2.0 * h0 - n) - cos(2.0 * h1 - n));
    }
    farol_open.r = clamp(open / float(FAROL_SLICES), 0.0, 1.0);
  }
}
