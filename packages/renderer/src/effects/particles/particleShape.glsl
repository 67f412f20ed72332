// Start position and direction of a particle, from random numbers.
// Farol; uniform points: Pharr, Jakob and Humphreys 2023, 4th edition, A.5; choice by area: Vose 1991
#include "particleRandom"
const int FAROL_POINT = 0;
const int FAROL_SPHERE = 1;
const int FAROL_CONE = 2;
const int FAROL_BOX = 3;
const int FAROL_MESH = 4;
uniform highp ivec2 farol_emitterShape; // x: shape, one of the constants above; y: triangles of the mesh
// sphere: radius (m), thickness (0 to 1); cone: radius (m), angle (rad); box: sides (m)
uniform highp vec3 farol_emitterSize;
// six texels a triangle: three corners, whose w hold share and alias (alias method), then three normals
uniform highp sampler2D farol_emitterSurface;

vec3 farol_onSphere(const in vec2 random) {
  float z = 1.0 - 2.0 * random.x;
  float r = sqrt(max(0.0, 1.0 - z * z));
  float turn = 6.28318530718 * random.y;
  return vec3(r * cos(turn), r * sin(turn), z);
}

vec4 farol_surfaceTexel(const in int triangle, const in int texel) {
  int at = triangle * 6 + texel, columns = textureSize(farol_emitterSurface, 0).x;
  return texelFetch(farol_emitterSurface, ivec2(at % columns, at / columns), 0);
}

void farol_onSurface(const in vec3 random, const in float choice, out vec3 position, out vec3 direction) {
  int triangle = min(int(random.x * float(farol_emitterShape.y)), farol_emitterShape.y - 1);
  if (choice >= farol_surfaceTexel(triangle, 0).w) triangle = int(farol_surfaceTexel(triangle, 1).w);
  float root = sqrt(random.y);
  vec3 share = vec3(1.0 - root, root * (1.0 - random.z), root * random.z);
  position = direction = vec3(0.0);
  for (int i = 0; i < 3; i++) {
    position += share[i] * farol_surfaceTexel(triangle, i).xyz;
    direction += share[i] * farol_surfaceTexel(triangle, i + 3).xyz;
  }
}

// position and direction in the emitter's space (shape surface: in the space of its mesh)
void farol_beginParticle(const in highp uint number, out vec3 position, out vec3 direction) {
  vec3 random = farol_particleRandom(number, 2u);
  float turn = 6.28318530718 * random.y;
  vec2 around = vec2(cos(turn), sin(turn));
  vec3 size = farol_emitterSize;
  position = vec3(0.0);
  direction = vec3(0.0, 1.0, 0.0);
  if (farol_emitterShape.x == FAROL_POINT) {
    direction = farol_onSphere(random.xy);
  } else if (farol_emitterShape.x == FAROL_SPHERE) {
    direction = farol_onSphere(random.xy);
    float inner = 1.0 - size.y;
    position = direction * size.x * pow(mix(inner * inner * inner, 1.0, random.z), 1.0 / 3.0);
  } else if (farol_emitterShape.x == FAROL_CONE) {
    float away = sqrt(random.x);
    position.xz = size.x * away * around;
    direction = vec3(sin(size.y * away) * around.x, cos(size.y * away), sin(size.y * away) * around.y);
  } else if (farol_emitterShape.x == FAROL_BOX) {
    position = size * (random - 0.5);
  } else {
    farol_onSurface(random, farol_particleRandom(number, 3u).x, position, direction);
  }
}
