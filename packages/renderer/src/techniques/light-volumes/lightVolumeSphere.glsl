// The vertices of a sphere round each light of a run, instanced, made from gl_VertexID: 576 a light.
// Hargreaves and Harris 2004, Deferred Shading; thesis 3.2.3.2
#include "lightTable"
#include "lightVolumeWide"
uniform highp int farol_firstRecord;
uniform highp vec4 farol_fit; // xy: scale, zw: shift from the picture's to the buffer's normalised device coordinates
flat out highp int farol_record;
//# main
const int SEGMENTS = 12;
const int RINGS = 8;
farol_record = farol_firstRecord + gl_InstanceID;
vec4 sphere = farol_lightSphere(farol_record);
int quad = gl_VertexID / 6;
int corner = gl_VertexID - quad * 6;
float east = float(quad - quad / SEGMENTS * SEGMENTS) + (corner == 1 || corner == 2 || corner == 4 ? 1.0 : 0.0);
float south = float(quad / SEGMENTS) + (corner == 2 || corner == 4 || corner == 5 ? 1.0 : 0.0);
float longitude = east * 6.28318531 / float(SEGMENTS);
float latitude = south * 3.14159265 / float(RINGS);
// 1.06 keeps the flat faces outside the sphere
vec3 offset = farol_lightRange(sphere) * 1.06
  * vec3(sin(latitude) * cos(longitude), cos(latitude), sin(latitude) * sin(longitude));
if (farol_isTooWide(sphere)) {
  gl_Position = farol_wholePicture();
} else {
  gl_Position = projectionMatrix * vec4(farol_lightPosition(sphere) + offset, 1.0);
  gl_Position.z = farol_volumeZ(gl_Position, sphere);
  gl_Position.xy = gl_Position.xy * farol_fit.xy + gl_Position.w * farol_fit.zw;
}
