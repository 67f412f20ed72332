// View-space position from window depth, precise also near 1, since it uses 1 - depth.
// Farol; uniforms by gpu/unprojectUniforms.ts; perspective, orthographic and off-centre projections
#include "depthMode"
uniform highp vec4 farol_unprojectZ; // view z = (x + y e) / (z + w e), e = 1 - depth, or reversed depth itself
uniform highp vec4 farol_unprojectXY; // view xy = (ndc + zw) * xy, times -z in perspective
uniform highp float farol_perspective; // 1 for a perspective camera, 0 for an orthographic one

// view-space z (m) of a depth-buffer value, negative before the camera
float farol_viewZ(const in float depth) {
  if (farol_depthMode.y > 0.0) return 1.0 - exp2(depth * farol_depthMode.y);
  float e = farol_depthMode.x > 0.0 ? depth : 1.0 - depth;
  return (farol_unprojectZ.x + farol_unprojectZ.y * e) / (farol_unprojectZ.z + farol_unprojectZ.w * e);
}

// uv: 0..1 over the picture; z: m, negative before the camera
vec3 farol_unprojectAt(const in vec2 uv, const in float z) {
  return vec3((uv * 2.0 - 1.0 + farol_unprojectXY.zw) * farol_unprojectXY.xy * mix(1.0, -z, farol_perspective), z);
}

// position of a pixel, view space (m), from its depth-buffer value (0 to 1)
vec3 farol_unproject(const in vec2 uv, const in float depth) {
  return farol_unprojectAt(uv, farol_viewZ(depth));
}
