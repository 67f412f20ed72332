// Vertices of an icosahedron around each light of a field, instanced, computed from gl_VertexID: 60 a light.
// Hargreaves and Harris 2004, Deferred Shading
#include "lightTable"
#include "lightVolumeWide"
uniform highp int farol_firstRecord;
uniform highp vec4 farol_fit; // normalised device coordinates of the picture to those of the target: xy scale, zw shift
flat out highp int farol_record;
const int FAROL_CORNERS[60] = int[60](0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4, 11, 10, 2,
  10, 7, 6, 7, 1, 8, 3, 9, 4, 3, 4, 2, 3, 2, 6, 3, 6, 8, 3, 8, 9, 4, 9, 5, 2, 4, 11, 6, 2, 10, 8, 6, 7, 9, 8, 1);

// corner of the unit icosahedron: 0 to 3 lie in the plane z = 0, 4 to 7 in x = 0, 8 to 11 in y = 0
vec3 farol_icosahedronCorner(const in int corner) {
  float first = (corner & 1) == 0 ? -0.525731112 : 0.525731112;
  float second = (corner & 2) == 0 ? 0.850650808 : -0.850650808;
  if (corner < 4) return vec3(first, second, 0.0);
  return corner < 8 ? vec3(0.0, first, second) : vec3(second, 0.0, first);
}
//# main
farol_record = farol_firstRecord + gl_InstanceID;
vec4 sphere = farol_lightSphere(farol_record);
// 1.33 times the range keeps the icosahedron's faces outside the light's sphere
vec4 around = vec4(farol_lightPosition(sphere), farol_lightRange(sphere) * 1.33);
if (sphere.x > 1e14) {
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0); // a light without effect has no volume: all its vertices are clipped
} else if (farol_isTooWide(around)) {
  gl_Position = farol_wholePicture();
} else {
  vec3 offset = farol_icosahedronCorner(FAROL_CORNERS[gl_VertexID]) * around.w;
  gl_Position = projectionMatrix * vec4(around.xyz + offset, 1.0);
  gl_Position.z = farol_volumeZ(gl_Position, around);
  gl_Position.xy = gl_Position.xy * farol_fit.xy + gl_Position.w * farol_fit.zw;
}
