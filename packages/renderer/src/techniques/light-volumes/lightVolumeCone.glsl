// The vertices of a cone for each spot light of a run, instanced, made from gl_VertexID: 72 a light.
// Hargreaves and Harris 2004, Deferred Shading; thesis 3.2.3.2
#include "lightTable"
#include "lightVolumeWide"
uniform highp int farol_firstRecord;
uniform highp vec4 farol_fit; // xy: scale, zw: shift from the picture's to the buffer's normalised device coordinates
flat out highp int farol_record;
//# main
const int SEGMENTS = 12;
farol_record = farol_firstRecord + gl_InstanceID;
vec4 sphere = farol_lightSphere(farol_record);
vec3 apex = farol_lightPosition(sphere);
float range = farol_lightRange(sphere);
vec4 cone = farol_lightCone(farol_record);
vec3 axis = -farol_lightAxis(cone);
float cutoff = farol_lightCutoff(cone);
vec3 side = normalize(abs(axis.y) < 0.9 ? cross(axis, vec3(0.0, 1.0, 0.0)) : cross(axis, vec3(1.0, 0.0, 0.0)));
vec3 up = cross(axis, side);
// 1.04 keeps the flat faces outside the cone
float radius = range * 1.04 * sqrt(1.0 - cutoff * cutoff) / cutoff;
int triangle = gl_VertexID / 3;
int corner = gl_VertexID - triangle * 3;
bool cap = triangle >= SEGMENTS;
vec3 offset = cap ? axis * range : vec3(0.0);
if (corner > 0) {
  float angle = float(triangle + ((corner == 1) == cap ? 0 : 1)) * 6.28318531 / float(SEGMENTS);
  offset = axis * range + radius * (cos(angle) * side + sin(angle) * up);
}
vec4 around = vec4(apex, length(vec2(range, radius)));
if (farol_isTooWide(around)) {
  gl_Position = farol_wholePicture();
} else {
  gl_Position = projectionMatrix * vec4(apex + offset, 1.0);
  gl_Position.z = farol_volumeZ(gl_Position, around);
  gl_Position.xy = gl_Position.xy * farol_fit.xy + gl_Position.w * farol_fit.zw;
}
