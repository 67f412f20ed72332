// Light volumes that are too wide to clip in 32-bit floats, or that extend beyond the far plane.
// Farol
#include "depthMode"
uniform highp mat4 projectionMatrix;

// sphere: centre (view space) and radius (m)
bool farol_isTooWide(const in vec4 sphere) {
  if (projectionMatrix[2][3] == 0.0)
    return sphere.w * max(abs(projectionMatrix[0][0]), abs(projectionMatrix[1][1])) > 1e5;
  float near = abs(projectionMatrix[3][2] / (projectionMatrix[2][2] + (farol_depthMode.x > 0.0 ? 1.0 : -1.0)));
  return sphere.w > 1e5 * near && -sphere.z - sphere.w * 1.1 < near;
}

// clip-space z of a vertex: a volume that extends beyond the far plane has all vertices on it, else interpolated
// depths would be too near; vertices behind the camera are placed next to it, so that edges still cross the near
// plane
float farol_volumeZ(const in vec4 clip, const in vec4 sphere) {
  vec4 end = projectionMatrix * vec4(sphere.xy, sphere.z - sphere.w * 1.1, 1.0);
  bool beyond = farol_depthMode.x > 0.0 ? end.z < 0.0 : end.z > end.w;
  if (!beyond) return clip.z;
  float far = farol_depthMode.x > 0.0 ? 0.0 : clip.w;
  return clip.w > 0.0 ? far : mix(far, clip.z, 1e-3);
}

// in place of a volume that is too wide: a triangle over the picture, at the far end of depth, its back to the camera
vec4 farol_wholePicture() {
  if (gl_VertexID > 2) return vec4(0.0, 0.0, 0.0, 1.0);
  vec2 corner = vec2(gl_VertexID == 2 ? 3.0 : -1.0, gl_VertexID == 1 ? 3.0 : -1.0);
  if (projectionMatrix[0][0] * projectionMatrix[1][1] < 0.0) corner = corner.yx; // if mirrored, turns the triangle back
  return vec4(corner, farol_depthMode.x > 0.0 ? 0.0 : 1.0, 1.0);
}
