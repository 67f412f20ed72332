// Blends a decal's colour with that of the surface, and writes its normal, roughness and metalness over the surface's.
// Farol
#include "decalSurface"
#include "roundToHalf"
layout(location = 0) out highp vec4 farol_albedo;
layout(location = 1) out highp vec4 farol_normal;
layout(location = 2) out highp vec4 farol_material;
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy);
FarolDecal decal;
if (!farol_findDecal(pixel, decal)) discard;
farol_albedo = vec4(sqrt(decal.blended), 1.0);
farol_normal = vec4(0.0);
if (farol_decalValues.z < 1e8) {
  mat2 linear = mat2(farol_decalNormalMapTransform);
  vec2 uv = (farol_decalNormalMapTransform * vec3(decal.uv, 1.0)).xy;
  vec3 bent = textureGrad(farol_decalNormalMap, uv, linear * decal.across, linear * decal.up).xyz * 2.0 - 1.0;
  bent.xy *= farol_decalValues.zw;
  vec3 tangent = normalize(modelViewMatrix[0].xyz - decal.normal * dot(decal.normal, modelViewMatrix[0].xyz));
  vec3 bitangent = cross(decal.normal, tangent);
  vec3 normal = normalize(tangent * bent.x + bitangent * bent.y + decal.normal * bent.z);
  normal = normalize(mix(decal.normal, normal, decal.opacity));
  farol_normal = vec4(farol_roundToHalf(farol_encodeNormal(normal)), texelFetch(farol_surfaceNormal, pixel, 0).z, 1.0);
}
// only standard surfaces have a roughness; 0.2: square root of the usual reflectance at normal incidence
bool covers = farol_decalBlending == 1 && farol_shadingModel(decal.flags) == FAROL_STANDARD;
farol_material = covers ? vec4(farol_decalValues.xy, 0.2, decal.opacity) : vec4(0.0);
