// Adds one light to the sums of the light buffer, by the specular lobe that the thin G-buffer holds.
// three.js r187; Walter et al. 2007 (GGX), Heitz 2014 (height-correlated Smith), Blinn 1977, Schlick 1994
#include "ggx"
#include "incidentLight"
#include "lightSums"
#include "lightMask"

struct FarolLobe {
  bool physical;
  bool specular;
  bool splitsDiffuse; // whether F90 is below 1
  bool receivesShadows;
  vec3 normalVS;
  vec3 viewDirVS;
  float dotNV;
  float alphaSquared; // physical: alpha²; Blinn-Phong: shininess
  float lambdaV; // view-dependent part of the height-correlated Smith term
#ifdef FAROL_AREA_LIGHTS
  vec4 ltc; // the specular lobe's linear transform
#endif
};

// lobe, object: values stored in the thin G-buffer
FarolLobe farol_lobe(const in float lobe, const in float object, const in vec3 normalVS, const in vec3 viewDirVS) {
  FarolLobe l;
  l.physical = lobe > 0.0;
  l.specular = lobe != 0.0;
  l.splitsDiffuse = lobe >= 2.0;
  l.receivesShadows = object > 0.0;
  l.normalVS = normalVS;
  l.viewDirVS = viewDirVS;
  l.dotNV = dot(normalVS, viewDirVS);
  l.lambdaV = 0.0;
  if (l.physical) {
    float roughness = l.splitsDiffuse ? lobe - 2.0 : lobe;
    l.alphaSquared = roughness * roughness * roughness * roughness;
    float dotNV = clamp(l.dotNV, 0.0, 1.0);
    l.lambdaV = farol_smithLambda(l.alphaSquared, dotNV);
#ifdef FAROL_AREA_LIGHTS
    l.ltc = farol_ltcAt(roughness, dotNV, 0.0);
#endif
  } else l.alphaSquared = -1.0 - lobe;
  return l;
}

void farol_sumLight(inout FarolLightSums sums, const in FarolLobe lobe, const in vec3 positionVS,
  const in FarolLight light) {
  if (light.attenuation <= 0.0) return;
#ifdef FAROL_AREA_LIGHTS
  if (light.extension < 0) {
    if (!lobe.physical) return;
    vec3 toLight = light.direction * light.distance;
    FarolArea area = farol_areaAt(-light.extension, toLight, lobe.normalVS);
    if (area.window <= 0.0) return;
    vec3 arriving = area.window
      * farol_masked(light.color, light.mask, toLight, positionVS, FAROL_SHADOW_NORMAL_OF(lobe), lobe.receivesShadows);
    area = farol_toTangentSpace(area, farol_areaLobe(lobe.normalVS, lobe.viewDirVS, lobe.ltc).tangents);
    sums.rest += 3.1415926536 * farol_areaDiffuse(area) * arriving;
    sums.area += farol_areaSpecular(area, lobe.ltc) * arriving;
    return;
  }
#endif
  vec3 diffuseColor = vec3(1.0);
  vec3 specularColor = vec3(1.0);
  if (light.extension > 0) {
    diffuseColor = farol_extensionDiffuse(light.extension);
    specularColor = farol_extensionSpecular(light.extension);
    vec3 ambient = farol_extensionAmbient(light.extension) * light.attenuation;
    // with F90 below 1 `rest` holds another sum; `diffuse` takes the ambient part, which the material then scales by
    // 1 - F0
    if (lobe.physical && !lobe.splitsDiffuse) sums.rest += ambient;
    else sums.diffuse += ambient;
  }
  float dotNLRaw = dot(lobe.normalVS, light.direction);
  if (!(dotNLRaw > 0.0)) return;
  vec3 color = farol_masked(light.color, light.mask, light.direction * light.distance, positionVS,
    FAROL_SHADOW_NORMAL_OF(lobe), lobe.receivesShadows);
  diffuseColor *= color;
  specularColor *= color;
  float dotNL = min(dotNLRaw, 1.0);
  float dotLV = dot(light.direction, lobe.viewDirVS);
  // half vector h = (l + v) / |l + v|, |l + v|² = 2 + 2 l·v
  float halfScale = inversesqrt(max(2.0 + 2.0 * dotLV, 1e-8));
  float dotNH = clamp((dotNLRaw + lobe.dotNV) * halfScale, 0.0, 1.0);
  float dotVH = clamp((1.0 + dotLV) * halfScale, 0.0, 1.0);
  float fresnel = farol_schlickPower(dotVH);
  float specular = 0.0;
  if (lobe.physical) {
    specular = dotNL * farol_ggxLobe(lobe.alphaSquared, lobe.lambdaV, clamp(lobe.dotNV, 0.0, 1.0), dotNL, dotNH);
    sums.diffuse += dotNL * (1.0 - fresnel) * diffuseColor;
    if (lobe.splitsDiffuse) sums.rest += dotNL * fresnel * diffuseColor;
  } else {
    sums.diffuse += dotNL * diffuseColor;
    if (lobe.specular) specular = dotNL * farol_blinnPhongLobe(lobe.alphaSquared, dotNH);
  }
  sums.specularF0 += specular * (1.0 - fresnel) * specularColor;
  sums.specularF90 += specular * fresnel * specularColor;
}
