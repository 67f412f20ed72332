// Light on one surface, as by three's RE_Direct_Physical and RE_Direct_BlinnPhong, but with factors common to all
// lights outside of the loop: three sums, weighted at the end by the surface's colours.
// three.js r187; Walter et al. 2007 (GGX), Heitz 2014 (height-correlated Smith), Turquin 2018 (multiple scattering)
#include "ggx"
#include "incidentLight"
#include "lightMask"
#include "surfaceFlags"

struct FarolShading {
  int flags;
  vec3 positionVS;
  vec3 normalVS;
  vec3 viewDirVS;
  float dotNV; // cosine between view and normal, not clamped
  float alphaSquared; // physical materials: roughness to the fourth power; Blinn-Phong: shininess
  float lambdaV; // view-dependent part of the height-correlated Smith visibility
  float diffuse0; // 1 - F at normal incidence, F: Fresnel reflectance of the specular layer
  float diffuse90; // part of diffuse0 lost at grazing angles: factor of Schlick's fifth power
  vec3 diffuse; // diffuse sum over the lights: colour × N·L × (1 - Fresnel)
  vec3 specular; // specular sum over the lights: colour × N·L × visibility × distribution
  vec3 grazing; // sum over the lights: colour × N·L × visibility × distribution × Schlick's fifth power
  FAROL_AREA_SUM
#ifdef FAROL_VERTEX_NORMAL
  vec3 shadowNormalVS; // normal along which shadow lookups are offset (normalBias)
#endif
};

#ifdef FAROL_VERTEX_NORMAL
  #define FAROL_SHADOW_NORMAL_OF(s) s.shadowNormalVS
#elif ! defined( FAROL_SHADOW_NORMAL_OF ) // gbufferRead.glsl has a definition of its own
  #define FAROL_SHADOW_NORMAL_OF(s) s.normalVS
#endif
#define FAROL_LOOKUP_OF(s) s.positionVS, FAROL_SHADOW_NORMAL_OF(s), farol_receivesShadows(s.flags)

bool farol_isPhysical(const in FarolShading s) {
  return farol_shadingModel(s.flags) == FAROL_STANDARD;
}

// roughness: at least 0.045; f0, f90: grey reflectance of the specular layer
void farol_setPhysical(inout FarolShading s, const in float roughness, const in float f0, const in float f90) {
  float alpha = roughness * roughness;
  float dotNV = clamp(s.dotNV, 0.0, 1.0);
  s.alphaSquared = alpha * alpha;
  s.lambdaV = farol_smithLambda(s.alphaSquared, dotNV);
  s.diffuse0 = 1.0 - f0;
  s.diffuse90 = f90 - f0;
  FAROL_BEGIN_AREA_SUM
}

// direction: to the light, unit length; colours: irradiance of a surface that faces the light
void farol_addLight(inout FarolShading s, const in vec3 direction, const in vec3 diffuseColor,
  const in vec3 specularColor) {
  float dotNLRaw = dot(s.normalVS, direction);
  if (!(dotNLRaw > 0.0)) return; // also true for NaN, the normal of a surface without one
  float dotNL = min(dotNLRaw, 1.0);
#ifdef STANDARD
  // three's order of operations, since narrow lobes magnify rounding differences
  vec3 halfDirVS = normalize(direction + s.viewDirVS);
  float dotNH = clamp(dot(s.normalVS, halfDirVS), 0.0, 1.0);
  float dotVH = clamp(dot(s.viewDirVS, halfDirVS), 0.0, 1.0);
#else
  float dotLV = dot(direction, s.viewDirVS);
  // half vector h = (l + v) / |l + v|, |l + v|² = 2 + 2 l·v
  float halfScale = inversesqrt(max(2.0 + 2.0 * dotLV, 1e-8));
  float dotNH = clamp((dotNLRaw + s.dotNV) * halfScale, 0.0, 1.0);
  float dotVH = min((1.0 + dotLV) * halfScale, 1.0);
#endif
  float fresnel = farol_schlickPower(dotVH);
  float lobe;
  if (farol_isPhysical(s)) lobe = farol_ggxLobe(s.alphaSquared, s.lambdaV, clamp(s.dotNV, 0.0, 1.0), dotNL, dotNH);
  else lobe = farol_blinnPhongLobe(s.alphaSquared, dotNH);
  lobe *= dotNL;
  s.diffuse += dotNL * (s.diffuse0 - s.diffuse90 * fresnel) * diffuseColor;
  s.specular += lobe * specularColor;
  s.grazing += lobe * fresnel * specularColor;
}

FAROL_AREA_SHADING

void farol_addExtended(inout FarolShading s, const in FarolLight light) {
  FAROL_ADD_AREA(light)
  vec3 diffuseScale = vec3(1.0);
  vec3 specularScale = vec3(1.0);
  if (light.extension > 0) {
    diffuseScale = farol_extensionDiffuse(light.extension);
    specularScale = farol_extensionSpecular(light.extension);
    s.diffuse += farol_extensionAmbient(light.extension) * light.attenuation;
  }
  if (dot(s.normalVS, light.direction) <= 0.0) return; // this test comes before the mask, which costs more
#ifdef FAROL_UNBOUNDED_MASKS
  // farol_addLight is called in both branches, so that lights without a mask do not wait for a shadow
  if (light.mask > 0) {
    vec3 color = light.color * FAROL_MASK(light.mask, false, light.direction * light.distance, FAROL_LOOKUP_OF(s));
    farol_addLight(s, light.direction, color * diffuseScale, color * specularScale);
    return;
  }
#endif
  farol_addLight(s, light.direction, light.color * diffuseScale, light.color * specularScale);
}

// a light with a range, unless it is an area light; sphere, emission: texels of its record; isLit: whether its mask
// lets all through; plain point lights, the most frequent kind, skip most of this
void farol_addRead(inout FarolShading s, const in int record, const in vec4 sphere, const in vec4 emission,
  const in bool isLit) {
  vec3 toLight = farol_lightPosition(sphere) - s.positionVS;
  float range = farol_lightRange(sphere);
  float distanceSquared = dot(toLight, toLight);
  float ratio = distanceSquared / (range * range);
  if (ratio >= 1.0) return;
  vec3 direction = toLight * inversesqrt(max(distanceSquared, 1e-12));
  vec3 color = farol_lightColor(emission);
  float decay = farol_lightDecay(emission);
  float attenuation = farol_boundedAttenuation(distanceSquared, ratio, decay);
  vec3 specularScale = vec3(1.0);
  if (!farol_lightIsPlain(emission)) {
    vec4 details = farol_lightDetails(record);
    FAROL_SKIP_AREA(details)
    bool isMaskedPoint = false;
#ifdef FAROL_POINT_MASKS
    isMaskedPoint = farol_lightIsMaskedPoint(details);
#endif
    if (!isMaskedPoint) {
      int extension = farol_lightExtensionRecord(details);
      vec3 ambient = vec3(0.0);
      if (extension > 0) {
        attenuation = farol_extendedAttenuation(extension, sqrt(distanceSquared), range, decay);
        vec3 diffuseScale = farol_extensionDiffuse(extension);
        // diffuse and specular sums share one colour, but may be scaled differently
        specularScale = farol_extensionSpecular(extension) / max(diffuseScale, 1e-6);
        color *= max(diffuseScale, 1e-6);
        ambient = farol_extensionAmbient(extension);
      }
      if (farol_lightIsSpot(details)) {
        vec4 cone = farol_lightCone(record);
        attenuation *= farol_angularAttenuation(dot(direction, farol_lightAxis(cone)), farol_lightCutoff(cone),
          farol_lightPenumbra(details), farol_lightExponent(details));
      }
      if (attenuation <= 0.0) return;
      s.diffuse += ambient * attenuation;
    }
    if (dot(s.normalVS, direction) <= 0.0) return;
#if defined( FAROL_BOUNDED_MASKS ) || defined( FAROL_POINT_MASKS )
    // the mask is called at one place only, since compilers inline its code at each call
    if (isMaskedPoint || (farol_lightIsMasked(details) && !isLit)) {
      color *= attenuation * FAROL_MASK(farol_lightMaskRecord(details), isMaskedPoint, toLight, FAROL_LOOKUP_OF(s));
      farol_addLight(s, direction, color, color * specularScale);
      return;
    }
#endif
  }
  color *= attenuation;
  farol_addLight(s, direction, color, color * specularScale);
}

// a light with a range, unless it is an area light
void farol_addLocal(inout FarolShading s, const in int record) {
  farol_addRead(s, record, farol_lightSphere(record), farol_lightEmission(record), false);
}

// adds directional lights, and local lights without a range
void farol_addUnbounded(inout FarolShading s) {
  int last = farol_lightCounts.x + farol_lightCounts.y;
  for (int i = 0; i < last; i++) {
    farol_addExtended(s, farol_lightAt(i, s.positionVS));
  }
}
