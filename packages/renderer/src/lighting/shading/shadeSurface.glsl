// Lights a pixel of the G-buffer.
// three.js r187; Turquin 2018 (multiple scattering)
#include "gbufferRead"
#include "shading"
uniform highp sampler2D dfgLUT;

FarolShading farol_beginShading(const in ivec2 pixel, const in float depth, const in vec2 size) {
  FarolShading s;
  farol_readPixel = pixel;
  farol_readSize = size;
  s.flags = farol_unpackFlags(farol_gAlbedoAt(pixel).a);
  s.positionVS = farol_surfacePosition(pixel, depth, size);
  s.normalVS = farol_decodeNormal(farol_gNormalAt(pixel).xy);
  s.viewDirVS = farol_perspective == 0.0 ? vec3(0.0, 0.0, 1.0) : normalize(-s.positionVS);
  s.dotNV = dot(s.normalVS, s.viewDirVS);
  if (farol_isPhysical(s)) {
    vec4 material = farol_materialAt(pixel, s.flags);
    farol_setPhysical(s, max(material.r, 0.045), material.b * material.b, material.a);
  } else {
    s.alphaSquared = farol_hasVertexNormal(s.flags) ? 1.0 : farol_shininessAt(pixel);
    s.lambdaV = 0.0;
    s.diffuse0 = 1.0;
    s.diffuse90 = 0.0;
  }
  s.diffuse = s.specular = s.grazing = vec3(0.0);
  return s;
}

// radiance from the pixel's surface to the eye
vec3 farol_endShading(const in FarolShading s, const in ivec2 pixel) {
  vec3 albedo = farol_gAlbedoAt(pixel).rgb;
  albedo *= albedo;
  vec4 material = farol_materialAt(pixel, s.flags);
  if (farol_isPhysical(s)) {
    vec3 f0 = mix(vec3(material.b * material.b), albedo, material.g);
    vec2 dfg = texture(dfgLUT, vec2(material.r, clamp(s.dotNV, 0.0, 1.0))).rg;
    vec3 compensation = 1.0 + f0 * (1.0 / (dfg.x + dfg.y) - 1.0);
    return s.diffuse * albedo * ((1.0 - material.g) * 0.3183098861)
      + (f0 * (s.specular - s.grazing) + material.a * s.grazing) * compensation
      FAROL_AREA_SPECULAR(s, f0, material.a, max(material.r, 0.045));
  }
  float strength = farol_shadingModel(s.flags) == FAROL_PHONG ? material.a : 0.0;
  vec3 f0 = material.rgb * material.rgb;
  return s.diffuse * albedo * 0.3183098861 + (f0 * (s.specular - s.grazing) + s.grazing) * strength;
}
