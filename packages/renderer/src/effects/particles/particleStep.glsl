// One step of all particles of an emitter, a texel each: living ones move, and new ones begin in the next slots.
// Farol
#include "particleShape"
#include "particleMotion"
uniform highp sampler2D farol_particlePositions; // by slot; xyz: world space (m); w: age (s)
uniform highp sampler2D farol_particleVelocities; // by slot; xyz: m/s; w: life (s)
uniform highp ivec4 farol_beginning; // x: first new slot; y: number at once; z: number after that; w: slots in all
uniform highp uint farol_firstNumber; // number of the first new particle since the restart
uniform highp vec3 farol_stepTimes; // times (s): x: step; y: first particle after the start; z: between later ones
uniform highp mat4 farol_emitterStart; // world matrix of the emitter at the start of the step and at its end
uniform highp mat4 farol_emitterEnd;
uniform highp mat4 farol_carried; // motion of the emitter in the step, for living particles that move with it
uniform highp vec4 farol_lifeAndSpeed; // least and most lifetime (s), least and most speed (m/s)
uniform highp vec3 farol_inherited; // part of the emitter's velocity that new particles inherit (m/s)
layout(location = 0) out highp vec4 farol_position;
layout(location = 1) out highp vec4 farol_velocity;

// order: index among the particles that begin in the step
void farol_begin(const in int order) {
  highp uint number = farol_firstNumber + uint(order);
  vec3 random = farol_particleRandom(number, 0u);
  vec2 lifeAndSpeed = mix(farol_lifeAndSpeed.xz, farol_lifeAndSpeed.yw, random.xy);
  int late = order - farol_beginning.y;
  float start = late < 0 ? 0.0 : farol_stepTimes.y + float(late) * farol_stepTimes.z;
  float rest = max(0.0, farol_stepTimes.x - start);
  float share = start / farol_stepTimes.x;
  mat4 world = farol_emitterStart * (1.0 - share) + farol_emitterEnd * share;
  vec3 position, direction;
  farol_beginParticle(number, position, direction);
  position = (world * vec4(position, 1.0)).xyz;
  direction = mat3(world) * direction;
  vec3 velocity = farol_inherited + direction * (lifeAndSpeed.y * inversesqrt(max(dot(direction, direction), 1e-20)));
  farol_moveParticle(rest, position, velocity);
  farol_position = vec4(position, rest);
  farol_velocity = vec4(velocity, lifeAndSpeed.x);
}
//# main
ivec2 texel = ivec2(gl_FragCoord.xy);
int slot = texel.y * textureSize(farol_particlePositions, 0).x + texel.x;
int slots = farol_beginning.w;
int order = slot - farol_beginning.x;
if (order < 0) order += slots;
if (slot >= slots) {
  farol_position = farol_velocity = vec4(0.0);
} else if (order < farol_beginning.y + farol_beginning.z) {
  farol_begin(order);
} else {
  farol_position = texelFetch(farol_particlePositions, texel, 0);
  farol_velocity = texelFetch(farol_particleVelocities, texel, 0);
  float seconds = farol_stepTimes.x;
  farol_position.w += seconds;
  if (farol_position.w < farol_velocity.w) {
    farol_position.xyz = (farol_carried * vec4(farol_position.xyz, 1.0)).xyz;
    farol_velocity.xyz = mat3(farol_carried) * farol_velocity.xyz;
    farol_moveParticle(seconds, farol_position.xyz, farol_velocity.xyz);
  }
  else farol_position.w = farol_velocity.w;
}
