// Bits of the lights with a range that may reach each block of 8 × 8 × 4 froxels: 128 lights a texel.
// Olsson, Billeter and Assarsson 2012, Clustered Deferred and Forward Shading
#include "lightTable"
#include "fogSlices"
uniform highp ivec2 farol_fogBlocks; // number of blocks across and up
layout(location = 0) out highp uvec4 farol_lights;
//# main
ivec2 texel = ivec2(gl_FragCoord.xy);
ivec3 block = ivec3(texel % farol_fogBlocks, texel.x / farol_fogBlocks.x);
float near = farol_fogDepth(float(block.z * 4));
float far = farol_fogDepth(float(block.z * 4 + 4));
vec2 size = vec2(farol_fogGrid.xy);
vec2 low = farol_fogRayAt(vec2(block.xy * 8) / size).xy;
vec2 high = farol_fogRayAt(vec2(block.xy * 8 + 8) / size).xy;
vec3 least = vec3(min(min(low * near, low * far), min(high * near, high * far)), -far);
vec3 most = vec3(max(max(low * near, low * far), max(high * near, high * far)), -near);
int first = (texel.y / farol_fogBlocks.y) * 128;
int record = farol_lightCounts.x + farol_lightCounts.y + first;
int end = min(128, farol_lightCounts.z - first);
farol_lights = uvec4(0u);
for (int i = 0; i < end; i++) {
  vec4 sphere = farol_lightSphere(record + i);
  vec3 away = farol_lightPosition(sphere) - clamp(farol_lightPosition(sphere), least, most);
  float range = farol_lightRange(sphere);
  if (dot(away, away) >= range * range) continue;
  uint bit = 1u << (uint(i) & 31u);
  if (i < 32) farol_lights.x |= bit;
  else if (i < 64) farol_lights.y |= bit;
  else if (i < 96) farol_lights.z |= bit;
  else farol_lights.w |= bit;
}
