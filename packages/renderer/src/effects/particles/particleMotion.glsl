// Moves a particle over a time step: exact for constant acceleration and drag, with the noise of the step's start;
// bounces off planes and spheres.
// Farol; dv/dt = a - k v; exponential integrator: Hochbruck and Ostermann 2010
#include "particleNoise"
uniform highp vec4 farol_acceleration; // xyz: acceleration (m/s²); w: drag (1/s)
uniform highp vec4 farol_noise; // x: strength (m/s²); y: frequency (1/m); z: how far the noise has moved down (m)
const int FAROL_COLLIDERS = 4;
uniform int farol_colliderCount;
// colliders: unit normal and height (m) of a plane, centre and radius (m) of a sphere
uniform highp vec4 farol_colliders[FAROL_COLLIDERS];
uniform highp vec3 farol_bounces[FAROL_COLLIDERS]; // x: bounce, 0 to 1; y: friction, 0 to 1; z: 1 sphere, 0 plane

// where a path enters a sphere, as a share of the path; above 1 if it does not
float farol_meetsSphere(const in vec4 sphere, const in vec3 start, const in vec3 way) {
  vec3 from = start - sphere.xyz;
  float outside = dot(from, from) - sphere.w * sphere.w;
  float towards = dot(from, way);
  if (towards >= 0.0) return 2.0;
  if (outside <= 0.0) return 0.0;
  float root = towards * towards - dot(way, way) * outside;
  return root < 0.0 ? 2.0 : outside / (sqrt(root) - towards);
}

// seconds: length of the step; left: time in the step after start (s)
void farol_bounceParticle(const in vec4 collider, const in vec3 bounce, const in float seconds, inout float left,
  inout vec3 start, inout vec3 position, inout vec3 velocity, const in vec3 acceleration) {
  bool isSphere = bounce.z > 0.0;
  float before = dot(collider.xyz, start) - collider.w;
  float after = dot(collider.xyz, position) - collider.w;
  float share = isSphere ? farol_meetsSphere(collider, start, position - start)
    : after >= 0.0 ? 2.0 : before > 0.0 ? before / (before - after) : 0.0;
  if (share > 1.0) return;
  vec3 met = start + (position - start) * share;
  vec3 normal = isSphere ? normalize(met - collider.xyz) : collider.xyz;
  float towards = dot(normal, velocity);
  if (towards >= 0.0) return;
  left *= 1.0 - share;
  // speed at impact (m/s), less than at the step's end: gravity also acts after the impact
  float speed = min(0.0, towards - dot(normal, acceleration) * left);
  float kept = -speed * bounce.x;
  // no bounce if gravity would end it within the step: the particle comes to rest
  if (kept < -dot(normal, acceleration) * seconds) kept = 0.0;
  velocity = (velocity - normal * towards) * (1.0 - bounce.y) + normal * kept;
  start = met;
  position = met + velocity * left;
  if (isSphere) normal = normalize(position - collider.xyz);
  float height = isSphere ? dot(normal, collider.xyz) + collider.w : collider.w;
  position += normal * max(0.0, height - dot(normal, position));
}

void farol_moveParticle(const in float seconds, inout vec3 position, inout vec3 velocity) {
  vec3 acceleration = farol_acceleration.xyz;
  if (farol_noise.x != 0.0)
    acceleration += farol_noise.x * farol_curlNoise((position + vec3(0.0, farol_noise.z, 0.0)) * farol_noise.y);
  float x = farol_acceleration.w * seconds;
  // first: (1 - e^-x) / x; second: (1 - first) / x
  float first = x < 0.02 ? 1.0 - x * (0.5 - x * (0.16666667 - x * 0.04166667)) : (1.0 - exp(-x)) / x;
  float second = x < 0.02 ? 0.5 - x * (0.16666667 - x * 0.04166667) : (1.0 - first) / x;
  vec3 start = position;
  position += seconds * (first * velocity + seconds * second * acceleration);
  velocity = velocity * exp(-x) + seconds * first * acceleration;
  float left = seconds;
  for (int i = 0; i < farol_colliderCount; i++)
    farol_bounceParticle(farol_colliders[i], farol_bounces[i], seconds, left, start, position, velocity, acceleration);
}
