// Adds one light to the sums of the light buffer, by the specular lobe that the thin G-buffer holds.
// three.js r187; Walter et al. 2007 (GGX), Heitz 2014 (height-correlated Smith), Blinn 1977, Schlick 1994
#include "incidentLight"
#include "lightSums"
#include "lightMask"

struct FarolLobe {
  bool physical;
  bool specular;
  bool splitsDiffuse; // F90 below 1
  bool receivesShadows;
  vec3 normalVS;
  vec3 viewDirVS;
  float dotNV;
  float alphaSquared; // physical: alpha²; Blinn-Phong: shininess
  float lambdaV; // of the height-correlated Smith term
};

// lobe, object: as the thin G-buffer holds them
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
    l.lambdaV = sqrt(l.alphaSquared + (1.0 - l.alphaSquared) * dotNV * dotNV);
  } else l.alphaSquared = -1.0 - lobe;
  return l;
}

void farol_sumLight(inout FarolLightSums sums, const in FarolLobe lobe, const in vec3 positionVS,
  const in FarolLight light) {
  if (light.attenuation <= 0.0) return;
  vec3 diffuseColor = vec3(1.0);
  vec3 specularColor = vec3(1.0);
  if (light.extension > 0) {
    diffuseColor = farol_lightTexel(light.extension, 0).rgb;
    specularColor = farol_lightTexel(light.extension, 1).rgb;
    vec3 ambient = farol_lightTexel(light.extension, 2).rgb * light.attenuation;
    // with F90 below 1 there is no room: the ambient part then loses F0 of itself
    if (lobe.physical && !lobe.splitsDiffuse) sums.rest += ambient;
    else sums.diffuse += ambient;
  }
  float dotNLRaw = dot(lobe.normalVS, light.direction);
  if (!(dotNLRaw > 0.0)) return;
  vec3 color = FAROL_MASKED(light.color, light.mask, light.direction * light.distance, positionVS, lobe.normalVS,
    lobe.receivesShadows);
  diffuseColor *= color;
  specularColor *= color;
  float dotNL = min(dotNLRaw, 1.0);
  float dotLV = dot(light.direction, lobe.viewDirVS);
  // half vector h = (l + v) / |l + v|, |l + v|² = 2 + 2 l·v
  float halfScale = inversesqrt(max(2.0 + 2.0 * dotLV, 1e-8));
  float dotNH = clamp((dotNLRaw + lobe.dotNV) * halfScale, 0.0, 1.0);
  float dotVH = clamp((1.0 + dotLV) * halfScale, 0.0, 1.0);
  float fresnel = exp2((-5.55473 * dotVH - 6.98316) * dotVH);
  float specular = 0.0;
  if (lobe.physical) {
    float dotNV = clamp(lobe.dotNV, 0.0, 1.0);
    float visibility = 0.5 / max(dotNL * lobe.lambdaV
      + dotNV * sqrt(lobe.alphaSquared + (1.0 - lobe.alphaSquared) * dotNL * dotNL), 1e-6);
    float d = dotNH * dotNH * (lobe.alphaSquared - 1.0) + 1.0;
    specular = dotNL * visibility * 0.3183098861 * lobe.alphaSquared / (d * d);
    sums.diffuse += dotNL * (1.0 - fresnel) * diffuseColor;
    if (lobe.splitsDiffuse) sums.rest += dotNL * fresnel * diffuseColor;
  } else {
    sums.diffuse += dotNL * diffuseColor;
    if (lobe.specular)
      specular = dotNL * 0.25 * 0.3183098861 * (lobe.alphaSquared * 0.5 + 1.0) * pow(dotNH, lobe.alphaSquared);
  }
  sums.specularF0 += specular * (1.0 - fresnel) * specularColor;
  sums.specularF90 += specular * fresnel * specularColor;
}
