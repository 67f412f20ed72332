// Lights a pixel of the G-buffer by three's own lighting functions, after the pixel's shading model.
// three's RE_Direct_Physical and RE_Direct_BlinnPhong
#include "threeLighting"
#include "gbufferRead"
#include "incidentLight"
uniform bool isOrthographic;

struct FarolShading {
  int model;
  vec3 positionVS;
  vec3 normalVS;
  vec3 viewDirVS;
  vec3 diffuse; // what ambient light of a light is reflected by
  PhysicalMaterial physical;
  BlinnPhongMaterial phong;
};

FarolShading farol_beginShading(const in FarolSurface surface) {
  FarolShading shading;
  shading.model = surface.flags & 3;
  shading.positionVS = surface.positionVS;
  shading.normalVS = surface.normalVS;
  shading.viewDirVS = isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(-surface.positionVS);
  shading.diffuse = surface.albedo;
  if (shading.model == 1) {
    float metalness = surface.material.g;
    shading.physical.diffuseColor = surface.albedo;
    shading.physical.diffuseContribution = surface.albedo * (1.0 - metalness);
    shading.physical.metalness = metalness;
    shading.physical.roughness = surface.material.r;
    shading.physical.specularColor = vec3(surface.material.b * surface.material.b);
    shading.physical.specularColorBlended = mix(shading.physical.specularColor, surface.albedo, metalness);
    shading.physical.specularF90 = surface.material.a;
    float dotNV = saturate(dot(shading.normalVS, shading.viewDirVS));
    shading.physical.dfg = texture(dfgLUT, vec2(shading.physical.roughness, dotNV)).rg;
    shading.physical.multiScatteringCompensation = 1.0
      + shading.physical.specularColorBlended * (1.0 / (shading.physical.dfg.x + shading.physical.dfg.y) - 1.0);
    shading.diffuse = shading.physical.diffuseContribution;
  } else {
    shading.phong.diffuseColor = surface.albedo;
    shading.phong.specularColor = surface.material.rgb * surface.material.rgb;
    shading.phong.specularShininess = surface.accumulation.a;
    shading.phong.specularStrength = shading.model == 2 ? surface.material.a : 0.0;
  }
  return shading;
}

void farol_shade(const in FarolShading shading, const in FarolLight light, inout ReflectedLight reflectedLight) {
  IncidentLight directLight;
  directLight.direction = light.direction;
  directLight.color = light.color;
  directLight.visible = true;
  ReflectedLight added = ReflectedLight(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
  if (shading.model == 1) {
    RE_Direct_Physical(directLight, shading.positionVS, shading.normalVS, shading.viewDirVS, vec3(0.0), shading.physical, added);
  } else {
    RE_Direct_BlinnPhong(directLight, shading.positionVS, shading.normalVS, shading.viewDirVS, vec3(0.0), shading.phong, added);
  }
  if (light.extension > 0) {
    added.directDiffuse = added.directDiffuse * farol_lightTexel(light.extension, 0).rgb
      + farol_lightTexel(light.extension, 2).rgb * light.attenuation * BRDF_Lambert(shading.diffuse);
    added.directSpecular *= farol_lightTexel(light.extension, 1).rgb;
  }
  reflectedLight.directDiffuse += added.directDiffuse;
  reflectedLight.directSpecular += added.directSpecular;
}
