// Window depth (0..1) to view-space z (m, negative before the camera) and back, perspective and orthographic.
// OpenGL ES 3.0 specification, 2.12 (coordinate transformations)
//? farol_viewZFromDepth(0.25, mat4(1.0)) == -0.5
//? farol_viewZFromDepth(0.0, mat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2, -1, 0, 0, -3, 0)) == -1.0
//? farol_viewZFromDepth(1.0, mat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2, -1, 0, 0, -3, 0)) == -3.0
//? farol_depthFromViewZ(-1.5, mat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2, -1, 0, 0, -3, 0)) == 0.5
//? mat4 p = mat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -0.25, 0, 0, 0, -1.5, 1); farol_viewZFromDepth(farol_depthFromViewZ(-7.0, p), p) == -7.0
float farol_viewZFromDepth(const in float depth, const in mat4 projection) {
  float ndc = depth * 2.0 - 1.0;
  return (projection[3].z - ndc * projection[3].w) / (ndc * projection[2].w - projection[2].z);
}

float farol_depthFromViewZ(const in float viewZ, const in mat4 projection) {
  return (projection[2].z * viewZ + projection[3].z) / (projection[2].w * viewZ + projection[3].w) * 0.5 + 0.5;
}
