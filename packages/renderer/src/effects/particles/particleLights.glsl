// The lights of an emitter's particles in a LightField's layout, a texel each.
// Farol
#include "particleCurves"
uniform highp sampler2D farol_particlePositions; // by slot; xyz: world space (m); w: age (s)
uniform highp sampler2D farol_particleVelocities; // by slot; xyz: m/s; w: life (s)
uniform highp ivec3 farol_lightOf; // x: every x-th particle is a light; y: slots; z: lights a row
uniform highp vec2 farol_lightValues; // intensity (cd) and range (m) where the curves are 1
layout(location = 0) out highp vec4 farol_sphere; // xyz: world space (m); w: range (m), 0 for no light
layout(location = 1) out highp vec4 farol_emission; // linear colour times intensity (cd), decay
//# main
farol_sphere = vec4(0.0);
farol_emission = vec4(0.0, 0.0, 0.0, 2.0);
ivec2 texel = ivec2(gl_FragCoord.xy);
int slot = (texel.y * farol_lightOf.z + texel.x) * farol_lightOf.x;
int columns = textureSize(farol_particlePositions, 0).x;
ivec2 at = ivec2(slot % columns, slot / columns);
vec4 position = slot < farol_lightOf.y ? texelFetch(farol_particlePositions, at, 0) : vec4(0.0);
float life = slot < farol_lightOf.y ? texelFetch(farol_particleVelocities, at, 0).w : 0.0;
if (position.w < life) {
  vec4 color = farol_particleCurve(0, position.w / life);
  farol_sphere = vec4(position.xyz, farol_lightValues.y * farol_particleCurve(1, position.w / life).x);
  farol_emission.rgb = color.rgb * (color.a * farol_lightValues.x);
}
