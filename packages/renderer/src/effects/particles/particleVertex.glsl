// Places the vertices of a particle: a rectangle facing the camera, one stretched along its velocity, or a mesh.
// Farol; three.js r187's chunks for fog, clipping and logarithmic depth
//# stage vertex
#include "particleCurves"
#include "particleRandom"
#include <fog_pars_vertex>
#include <clipping_planes_pars_vertex>
#include <logdepthbuf_pars_vertex>
uniform highp sampler2D farol_particlePositions; // by slot; xyz: world space (m); w: age (s)
uniform highp sampler2D farol_particleVelocities; // by slot; xyz: m/s; w: life (s)
uniform highp ivec2 farol_particleSlots; // x: slot of the oldest particle; y: number of slots
uniform highp uint farol_oldestNumber;
uniform highp vec4 farol_sizeAndRotation; // xy: range of diameters (m); zw: range of initial rotations (rad)
uniform highp int farol_orientation; // orientation of meshes: 0 random, 1 as the emitter, 2 along the velocity
uniform highp mat3 farol_emitterTurn;
uniform highp vec4 farol_spinAndStretch; // xy: least and greatest spin (rad/s); z: stretch (s); w: brightness
uniform highp vec3 farol_flipBook; // flip book: x: columns, y: rows of pictures, z: cycles in a particle's life
out highp vec4 farol_particleColor;
out highp vec4 farol_particleUV; // xy, zw: uv in the current and the next picture of the flip book
out highp vec3 farol_particleBall; // xy: position on the particle, -1 to 1; z: share of the next picture, 0 to 1
out highp float farol_particleDistance; // distance along the view (m)
#ifdef FAROL_SORTED
uniform highp sampler2D farol_particleOrder; // particles from far to near: distance along the view (m), slot
#endif
#ifdef FAROL_LIT
#include "particleSurroundings"
// light on each slot's particle, a texture a colour; xyz: sum over lights of light × direction (view space); w: sum
uniform highp sampler2D farol_particleRed;
uniform highp sampler2D farol_particleGreen;
uniform highp sampler2D farol_particleBlue;
flat out highp mat3x4 farol_particleLit;
#endif

// v rotated about a unit axis (Rodrigues' formula)
vec3 farol_turn(const in vec3 v, const in vec3 axis, const in float angle) {
  return mix(axis * dot(axis, v), v, cos(angle)) + cross(axis, v) * sin(angle);
}

// rotation of a mesh's +Y to a direction; identity for a zero direction
mat3 farol_axesAlong(const in vec3 direction) {
  float size = length(direction);
  if (size < 1e-6) return mat3(1.0);
  vec3 up = direction / size;
  vec3 right = normalize(cross(up, abs(up.z) < 0.99 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0)));
  return mat3(right, up, cross(right, up));
}

void farol_setPictures(const in vec2 place, const in float share) {
  float pictures = farol_flipBook.x * farol_flipBook.y;
  float at = min(share, 0.99999) * farol_flipBook.z * pictures;
  float first = floor(at);
  float last = ceil(farol_flipBook.z * pictures) - 1.0;
  farol_particleBall.z = at - first;
  for (int i = 0; i < 2; i++) {
    float picture = mod(min(first + float(i), last), pictures);
    vec2 cell = vec2(mod(picture, farol_flipBook.x), farol_flipBook.y - 1.0 - floor(picture / farol_flipBook.x));
    vec2 uv = (cell + place) / farol_flipBook.xy;
    if (i == 0) farol_particleUV.xy = uv;
    else farol_particleUV.zw = uv;
  }
}
//# main
#ifdef FAROL_MESH
int farol_order = gl_InstanceID;
vec2 farol_place = uv;
#else
int farol_order = gl_VertexID / 6;
int farol_corner = gl_VertexID % 6;
// a billboard's two triangles have the corners 0 1 2 and 0 2 3
bool farol_isRight = farol_corner == 1 || farol_corner == 2 || farol_corner == 4;
vec2 farol_place = vec2(farol_isRight, farol_corner == 2 || farol_corner > 3);
#endif
#ifdef FAROL_SORTED
int farol_orderColumns = textureSize(farol_particleOrder, 0).x;
ivec2 farol_orderTexel = ivec2(farol_order % farol_orderColumns, farol_order / farol_orderColumns);
int farol_slot = int(texelFetch(farol_particleOrder, farol_orderTexel, 0).y);
farol_order = farol_slot - farol_particleSlots.x;
if (farol_order < 0) farol_order += farol_particleSlots.y;
#else
int farol_slot = farol_particleSlots.x + farol_order;
if (farol_slot >= farol_particleSlots.y) farol_slot -= farol_particleSlots.y;
#endif
int farol_columns = textureSize(farol_particlePositions, 0).x;
ivec2 farol_texel = ivec2(farol_slot % farol_columns, farol_slot / farol_columns);
vec4 farol_center = texelFetch(farol_particlePositions, farol_texel, 0);
vec4 farol_motion = texelFetch(farol_particleVelocities, farol_texel, 0);
float farol_life = farol_slot < farol_particleSlots.y ? farol_motion.w : 0.0;
gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
farol_particleColor = farol_particleUV = vec4(0.0);
farol_particleBall = vec3(0.0);
farol_particleDistance = 0.0;
vec4 mvPosition = vec4(0.0, 0.0, -1.0, 1.0);
if (farol_center.w < farol_life) {
  float farol_share = farol_center.w / farol_life;
  highp uint farol_number = farol_oldestNumber + uint(farol_order);
  vec3 farol_random = farol_particleRandom(farol_number, 1u);
  vec4 farol_curves = farol_particleCurve(1, farol_share);
  float farol_size = mix(farol_sizeAndRotation.x, farol_sizeAndRotation.y, farol_random.x) * farol_curves.x;
  float farol_angle = mix(farol_sizeAndRotation.z, farol_sizeAndRotation.w, farol_random.y)
    + mix(farol_spinAndStretch.x, farol_spinAndStretch.y, farol_random.z) * farol_curves.y * farol_life;
  farol_particleColor = farol_particleCurve(0, farol_share);
  farol_particleColor.rgb *= farol_spinAndStretch.w;
  farol_setPictures(farol_place, farol_share);
  mvPosition = viewMatrix * vec4(farol_center.xyz, 1.0);
  vec3 farol_normalVS = vec3(0.0, 0.0, 1.0);
#ifdef FAROL_MESH
  vec3 farol_axisRandom = farol_particleRandom(farol_number, 4u);
  float farol_z = 1.0 - 2.0 * farol_axisRandom.x;
  float farol_around = 6.28318530718 * farol_axisRandom.y;
  vec3 farol_axis = vec3(sqrt(1.0 - farol_z * farol_z) * vec2(cos(farol_around), sin(farol_around)), farol_z);
  mat3 farol_axes = mat3(1.0);
  if (farol_orientation > 0) {
    farol_axis = vec3(0.0, 1.0, 0.0);
    farol_axes = farol_emitterTurn;
    if (farol_orientation == 2) farol_axes = farol_axesAlong(farol_motion.xyz);
  }
  vec3 farol_turned = farol_axes * farol_turn(position, farol_axis, farol_angle);
  mvPosition = viewMatrix * vec4(farol_center.xyz + farol_turned * farol_size, 1.0);
  farol_normalVS = mat3(viewMatrix) * farol_axes * farol_turn(normal, farol_axis, farol_angle);
  farol_particleBall.xy = farol_place;
#else
  vec2 farol_offset = farol_place * 2.0 - 1.0;
  farol_particleBall.xy = farol_offset;
  #ifdef FAROL_STRETCHED
    vec3 farol_velocityVS = mat3(viewMatrix) * farol_motion.xyz;
    float farol_speed = length(farol_velocityVS);
    vec3 farol_toEye = projectionMatrix[2][3] != 0.0 ? -mvPosition.xyz : vec3(0.0, 0.0, 1.0);
    vec3 farol_side = cross(farol_velocityVS, farol_toEye);
    float farol_sideLength = length(farol_side);
    bool farol_points = farol_sideLength > 1e-6 * farol_speed * length(farol_toEye) && farol_speed > 1e-6;
    vec3 farol_along = farol_points ? farol_velocityVS / farol_speed : vec3(0.0, 1.0, 0.0);
    farol_side = farol_points ? farol_side / farol_sideLength : vec3(1.0, 0.0, 0.0);
    float farol_length = farol_speed * farol_spinAndStretch.z;
    // the streak's head is at the particle's position
    mvPosition.xyz += farol_side * (0.5 * farol_size * farol_offset.x)
      + farol_along * (0.5 * farol_size * farol_offset.y - farol_length * (1.0 - farol_place.y));
  #else
    float farol_cos = cos(farol_angle), farol_sin = sin(farol_angle);
    farol_offset = mat2(farol_cos, farol_sin, -farol_sin, farol_cos) * farol_offset;
    farol_particleBall.xy = farol_offset;
    mvPosition.xy += 0.5 * farol_size * farol_offset;
  #endif
#endif
  farol_particleDistance = -mvPosition.z;
  gl_Position = projectionMatrix * mvPosition;
#ifdef FAROL_LIT
  farol_particleLit[0] = texelFetch(farol_particleRed, farol_texel, 0);
  farol_particleLit[1] = texelFetch(farol_particleGreen, farol_texel, 0);
  farol_particleLit[2] = texelFetch(farol_particleBlue, farol_texel, 0);
  #ifdef FAROL_MESH
    vec4 farol_facing = vec4(normalize(farol_normalVS), 1.0);
    // 1 / 2π: Lambert's 1 / π, halved since a light at 90° counts half
    farol_particleColor.rgb *= 0.15915494 * max(vec3(0.0), farol_facing * farol_particleLit)
      + farol_surroundingLight(farol_facing.xyz * mat3(viewMatrix));
  #endif
#endif
}
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <fog_vertex>
