// Multiplies a surface's indirect light by the ratio of its albedos with and without the decal.
// Farol
#include "decalSurface"
uniform lowp sampler2D farol_surfaceMaterial; // G-buffer's material attachment; y: metalness of a MeshStandardMaterial
uniform bool farol_environment; // whether an environment map lights the scene, the only indirect light on metal
layout(location = 0) out highp vec4 farol_accumulation;
layout(location = 1) out highp vec4 farol_indirect;
//# main
FarolDecal decal;
if (!farol_findDecal(ivec2(gl_FragCoord.xy), decal)) discard;
// ratio of albedos; divides by at least the smallest albedo above 0 that the 8-bit square root can hold
vec3 before = decal.albedo;
vec3 after = decal.blended;
if (farol_decalBlending == 1 && !farol_environment && farol_shadingModel(decal.flags) == FAROL_STANDARD) {
  before *= 1.0 - texelFetch(farol_surfaceMaterial, ivec2(gl_FragCoord.xy), 0).g;
  after = mix(before, decal.color * (1.0 - farol_decalValues.y), decal.opacity);
}
vec3 ratio = min(after / max(before, 1.5e-5), 64.0);
farol_accumulation = farol_indirect = vec4(ratio, 1.0);
