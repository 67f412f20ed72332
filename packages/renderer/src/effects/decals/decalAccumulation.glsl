// Takes the indirect light that the surface gave off to what it gives off with the decal on it, by multiplication.
// Farol
#include "decalSurface"
uniform lowp sampler2D farol_surfaceMaterial; // y: metalness, of standard surfaces
uniform bool farol_environment; // what is metal reflects an environment in place of scattering ambient light
layout(location = 0) out highp vec4 farol_accumulation;
layout(location = 1) out highp vec4 farol_indirect;
//# main
FarolDecal decal;
if (!farol_findDecal(ivec2(gl_FragCoord.xy), decal)) discard;
// a square root in 8 bits ends at this albedo: below it, black
vec3 before = decal.albedo;
vec3 after = decal.blended;
if (farol_decalBlending == 1 && !farol_environment && farol_shadingModel(decal.flags) == FAROL_STANDARD) {
  before *= 1.0 - texelFetch(farol_surfaceMaterial, ivec2(gl_FragCoord.xy), 0).g;
  after = mix(before, decal.color * (1.0 - farol_decalValues.y), decal.opacity);
}
vec3 ratio = min(after / max(before, 1.5e-5), 64.0);
farol_accumulation = farol_indirect = vec4(ratio, 1.0);
