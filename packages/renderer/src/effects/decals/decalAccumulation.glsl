// Multiplies a surface's indirect light by the ratio of its albedo with the decal to that without.
// Farol
#include "decalSurface"
uniform lowp sampler2D farol_surfaceMaterial; // G-buffer's material; y: metalness of a MeshStandardMaterial
uniform bool farol_environment; // whether the scene has an environment; metal reflects it and scatters no ambient light
layout(location = 0) out highp vec4 farol_accumulation;
layout(location = 1) out highp vec4 farol_indirect;
//# main
FarolDecal decal;
if (!farol_findDecal(ivec2(gl_FragCoord.xy), decal)) discard;
// smallest albedo above 0 that the 8-bit square root holds; below it, black
vec3 before = decal.albedo;
vec3 after = decal.blended;
if (farol_decalBlending == 1 && !farol_environment && farol_shadingModel(decal.flags) == FAROL_STANDARD) {
  before *= 1.0 - texelFetch(farol_surfaceMaterial, ivec2(gl_FragCoord.xy), 0).g;
  after = mix(before, decal.color * (1.0 - farol_decalValues.y), decal.opacity);
}
vec3 ratio = min(after / max(before, 1.5e-5), 64.0);
farol_accumulation = farol_indirect = vec4(ratio, 1.0);
