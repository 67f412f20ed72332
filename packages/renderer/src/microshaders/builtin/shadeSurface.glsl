// Lights a pixel of the G-buffer as three's RE_Direct_Physical and RE_Direct_BlinnPhong do, with what the lights have in
// common taken out of the loop: three sums, weighted at the end by the surface's colours.
// three.js r187; Walter et al. 2007 (GGX), Heitz 2014 (height-correlated Smith), Turquin 2018 (multiple scattering)
#include "gbufferRead"
#include "incidentLight"
uniform highp sampler2D dfgLUT;

struct FarolShading {
  bool physical;
  vec3 positionVS;
  vec3 normalVS;
  vec3 viewDirVS;
  float dotNV; // clamped to 0..1
  float dotNVRaw;
  float alphaSquared; // physical: alpha²; Blinn-Phong: shininess
  float lambdaV; // of the height-correlated Smith term
  float f0; // of the dielectric, physical only
  float f90;
  vec3 diffuse; // sum of c N·L (1 - F)
  vec3 specularF0; // sum of c N·L V D (1 - f), f: Schlick's fifth power
  vec3 specularF90; // sum of c N·L V D f
  vec3 ambient; // ambient light of the lights themselves
};

FarolShading farol_beginShading(const in FarolSurface surface) {
  FarolShading s;
  s.physical = (surface.flags & 3) == 1;
  s.positionVS = surface.positionVS;
  s.normalVS = surface.normalVS;
  s.viewDirVS = farol_perspective == 0.0 ? vec3(0.0, 0.0, 1.0) : normalize(-surface.positionVS);
  s.dotNVRaw = dot(s.normalVS, s.viewDirVS);
  s.dotNV = clamp(s.dotNVRaw, 0.0, 1.0);
  if (s.physical) {
    float roughness = max(surface.material.r, 0.045);
    float alpha = roughness * roughness;
    s.alphaSquared = alpha * alpha;
    s.lambdaV = sqrt(s.alphaSquared + (1.0 - s.alphaSquared) * s.dotNV * s.dotNV);
    s.f0 = surface.material.b * surface.material.b;
    s.f90 = surface.material.a;
  } else {
    s.alphaSquared = surface.accumulation.a;
    s.lambdaV = 0.0;
    s.f0 = 0.0;
    s.f90 = 0.0;
  }
  s.diffuse = s.specularF0 = s.specularF90 = s.ambient = vec3(0.0);
  return s;
}

void farol_shade(inout FarolShading s, const in FarolLight light) {
  vec3 diffuseColor = light.color;
  vec3 specularColor = light.color;
  if (light.extension > 0) {
    diffuseColor *= farol_lightTexel(light.extension, 0).rgb;
    specularColor *= farol_lightTexel(light.extension, 1).rgb;
    s.ambient += farol_lightTexel(light.extension, 2).rgb * light.attenuation;
  }
  float dotNLRaw = dot(s.normalVS, light.direction);
  if (dotNLRaw <= 0.0) return;
  float dotNL = min(dotNLRaw, 1.0);
  float dotLV = dot(light.direction, s.viewDirVS);
  // half vector h = (l + v) / |l + v|, |l + v|² = 2 + 2 l·v
  float halfScale = inversesqrt(max(2.0 + 2.0 * dotLV, 1e-8));
  float dotNH = clamp((dotNLRaw + s.dotNVRaw) * halfScale, 0.0, 1.0);
  float dotVH = clamp((1.0 + dotLV) * halfScale, 0.0, 1.0);
  float fresnel = exp2((-5.55473 * dotVH - 6.98316) * dotVH);
  float specular;
  float diffuse = dotNL;
  if (s.physical) {
    float visibility = 0.5 / max(dotNL * s.lambdaV + s.dotNV * sqrt(s.alphaSquared + (1.0 - s.alphaSquared) * dotNL * dotNL), 1e-6);
    float d = dotNH * dotNH * (s.alphaSquared - 1.0) + 1.0;
    specular = dotNL * visibility * 0.3183098861 * s.alphaSquared / (d * d);
    diffuse *= 1.0 - (s.f0 * (1.0 - fresnel) + s.f90 * fresnel);
  } else {
    specular = dotNL * 0.25 * 0.3183098861 * (s.alphaSquared * 0.5 + 1.0) * pow(dotNH, s.alphaSquared);
  }
  s.diffuse += diffuse * diffuseColor;
  s.specularF90 += specular * fresnel * specularColor;
  s.specularF0 += specular * (1.0 - fresnel) * specularColor;
}

vec3 farol_endShading(const in FarolShading s, const in FarolSurface surface) {
  vec3 albedo = surface.albedo;
  if (s.physical) {
    vec3 f0 = mix(vec3(s.f0), surface.albedo, surface.material.g);
    vec2 dfg = texture(dfgLUT, vec2(surface.material.r, s.dotNV)).rg;
    vec3 compensation = 1.0 + f0 * (1.0 / (dfg.x + dfg.y) - 1.0);
    albedo *= 1.0 - surface.material.g;
    return (s.diffuse + s.ambient) * albedo * 0.3183098861 + (f0 * s.specularF0 + s.f90 * s.specularF90) * compensation;
  }
  float strength = (surface.flags & 3) == 2 ? surface.material.a : 0.0;
  vec3 f0 = surface.material.rgb * surface.material.rgb;
  return (s.diffuse + s.ambient) * albedo * 0.3183098861 + (f0 * s.specularF0 + s.specularF90) * strength;
}
