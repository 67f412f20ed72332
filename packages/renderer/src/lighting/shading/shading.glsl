// Light on one surface as three's RE_Direct_Physical and RE_Direct_BlinnPhong have it, with what the lights have in
// common taken out of the loop: three sums, weighted at the end by the surface's colours.
// three.js r187; Walter et al. 2007 (GGX), Heitz 2014 (height-correlated Smith), Turquin 2018 (multiple scattering)
#include "incidentLight"
#include "lightMask"

struct FarolShading {
  int flags;
  vec3 positionVS;
  vec3 normalVS;
  vec3 viewDirVS;
  float dotNV; // not clamped
  float alphaSquared; // physical: alpha²; Blinn-Phong: shininess
  float lambdaV; // of the height-correlated Smith term
  float diffuse0; // 1 - F at normal incidence, of the layer over the diffuse one
  float diffuse90; // what Schlick's fifth power takes from that
  vec3 diffuse; // sum of c N·L (1 - F)
  vec3 specular; // sum of c N·L V D
  vec3 grazing; // sum of c N·L V D f, f: Schlick's fifth power
#ifdef FAROL_VERTEX_NORMAL
  vec3 shadowNormalVS; // along which shadow maps are looked up some way off
#endif
};

#ifdef FAROL_VERTEX_NORMAL
  #define FAROL_SHADOW_NORMAL_OF(s) s.shadowNormalVS
#else
  #define FAROL_SHADOW_NORMAL_OF(s) s.normalVS
#endif
#define FAROL_LOOKUP_OF(s) s.positionVS, FAROL_SHADOW_NORMAL_OF(s), (s.flags & 16) != 0

bool farol_isPhysical(const in FarolShading s) {
  return (s.flags & 3) == 1;
}

// roughness: at least 0.045; f0, f90: of the layer over the diffuse one, grey
void farol_setPhysical(inout FarolShading s, const in float roughness, const in float f0, const in float f90) {
  float alpha = roughness * roughness;
  float dotNV = clamp(s.dotNV, 0.0, 1.0);
  s.alphaSquared = alpha * alpha;
  s.lambdaV = sqrt(s.alphaSquared + (1.0 - s.alphaSquared) * dotNV * dotNV);
  s.diffuse0 = 1.0 - f0;
  s.diffuse90 = f90 - f0;
}

// direction: to the light, unit; colours: what arrives at a surface that faces it
void farol_addLight(inout FarolShading s, const in vec3 direction, const in vec3 diffuseColor,
  const in vec3 specularColor) {
  float dotNLRaw = dot(s.normalVS, direction);
  if (!(dotNLRaw > 0.0)) return; // nor without a normal
  float dotNL = min(dotNLRaw, 1.0);
#ifdef STANDARD
  // as three has it: narrow lobes magnify its last bits
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
  float fresnel = exp2((-5.55473 * dotVH - 6.98316) * dotVH);
  float lobe;
  if (farol_isPhysical(s)) {
    float lambdaL = sqrt(s.alphaSquared + (1.0 - s.alphaSquared) * dotNL * dotNL);
    float d = dotNH * dotNH * (s.alphaSquared - 1.0) + 1.0;
    // V = 0.5 / (gv + gl), D = alpha² / (pi d²)
    lobe = 0.1591549431 * s.alphaSquared / (max(dotNL * s.lambdaV + clamp(s.dotNV, 0.0, 1.0) * lambdaL, 1e-6) * d * d);
  } else {
    lobe = 0.0795774716 * (s.alphaSquared * 0.5 + 1.0) * pow(dotNH, s.alphaSquared);
  }
  lobe *= dotNL;
  s.diffuse += dotNL * (s.diffuse0 - s.diffuse90 * fresnel) * diffuseColor;
  s.specular += lobe * specularColor;
  s.grazing += lobe * fresnel * specularColor;
}

void farol_addExtended(inout FarolShading s, const in FarolLight light) {
  vec3 diffuseScale = vec3(1.0);
  vec3 specularScale = vec3(1.0);
  if (light.extension > 0) {
    diffuseScale = farol_lightTexel(light.extension, 0).rgb;
    specularScale = farol_lightTexel(light.extension, 1).rgb;
    s.diffuse += farol_lightTexel(light.extension, 2).rgb * light.attenuation;
  }
  if (dot(s.normalVS, light.direction) <= 0.0) return; // masks cost more than the light
#ifdef FAROL_UNBOUNDED_MASKS
  // a call of its own, so that nothing has to wait for the shadow before it is needed
  if (light.mask > 0) {
    vec3 color = light.color * FAROL_MASK(light.mask, false, light.direction * light.distance, FAROL_LOOKUP_OF(s));
    farol_addLight(s, light.direction, color * diffuseScale, color * specularScale);
    return;
  }
#endif
  farol_addLight(s, light.direction, light.color * diffuseScale, light.color * specularScale);
}

// a point light of three that nothing masks, its first two texels
void farol_addPlain(inout FarolShading s, const in vec4 centre, const in vec3 color, const in float decay) {
  vec3 toLight = centre.xyz - s.positionVS;
  float distanceSquared = dot(toLight, toLight);
  float ratio = distanceSquared / (centre.w * centre.w);
  if (ratio >= 1.0) return;
  vec3 arriving = color * farol_boundedAttenuation(distanceSquared, ratio, decay);
  farol_addLight(s, toLight * inversesqrt(max(distanceSquared, 1e-12)), arriving, arriving);
}

// a light with a range, its first two texels; point lights of three, most of all lights, take the short way; isLit: its
// mask lets all through
void farol_addRead(inout FarolShading s, const in int record, const in vec4 centre, vec4 color, const in bool isLit) {
  vec3 toLight = centre.xyz - s.positionVS;
  float distanceSquared = dot(toLight, toLight);
  float ratio = distanceSquared / (centre.w * centre.w);
  if (ratio >= 1.0) return;
  vec3 direction = toLight * inversesqrt(max(distanceSquared, 1e-12));
  float decay = color.w >= 0.0 ? color.w : -1.0 - color.w;
  float attenuation = farol_boundedAttenuation(distanceSquared, ratio, decay);
  vec3 specularScale = vec3(1.0);
  if (color.w < 0.0) {
    vec4 cone = farol_lightTexel(record, 3);
#ifdef FAROL_POINT_MASKS
    if (cone.x < -1.0 && cone.w == 0.0) { // a point light of three with a mask
      if (dot(s.normalVS, direction) <= 0.0) return;
      color.rgb *= attenuation * FAROL_MASK(int(cone.z), true, toLight, FAROL_LOOKUP_OF(s));
      farol_addLight(s, direction, color.rgb, color.rgb);
      return;
    }
#endif
    int extension = int(cone.w);
    vec3 ambient = vec3(0.0);
    if (extension > 0) {
      attenuation = farol_extendedAttenuation(extension, sqrt(distanceSquared), centre.w, decay);
      vec3 diffuseScale = farol_lightTexel(extension, 0).rgb;
      // the sums take one colour; the specular one may have another scale
      specularScale = farol_lightTexel(extension, 1).rgb / max(diffuseScale, 1e-6);
      color.rgb *= max(diffuseScale, 1e-6);
      ambient = farol_lightTexel(extension, 2).rgb;
    }
    if (cone.x >= -1.0) { // a spot light
      vec4 axis = farol_lightTexel(record, 2);
      attenuation *= farol_angularAttenuation(dot(direction, axis.xyz), axis.w, cone.x, cone.y);
    }
    if (attenuation <= 0.0) return;
    s.diffuse += ambient * attenuation;
    if (dot(s.normalVS, direction) <= 0.0) return;
#ifdef FAROL_BOUNDED_MASKS
    if (cone.z > 0.0 && !isLit) {
      color.rgb *= attenuation * FAROL_MASK(int(cone.z), false, toLight, FAROL_LOOKUP_OF(s));
      farol_addLight(s, direction, color.rgb, color.rgb * specularScale);
      return;
    }
#endif
  }
  color.rgb *= attenuation;
  farol_addLight(s, direction, color.rgb, color.rgb * specularScale);
}

void farol_addBounded(inout FarolShading s, const in int record) {
  farol_addRead(s, record, farol_lightTexel(record, 0), farol_lightTexel(record, 1), false);
}

// the same, for all but plain point lights; isPlain: a mask that lets all through is all that keeps it from being one;
// both texels are asked for before either is looked at
void farol_addOther(inout FarolShading s, const in int record, const in bool isLit, const in bool isPlain) {
  vec4 centre = farol_lightTexel(record, 0);
  vec4 color = farol_lightTexel(record, 1);
#ifdef FAROL_POINT_MASKS
  if (isPlain) {
    farol_addPlain(s, centre, color.rgb, -1.0 - color.w);
    return;
  }
#endif
#ifdef FAROL_BOUNDED_MASKS
  if (color.w < 0.0) farol_addRead(s, record, centre, color, isLit);
#else
  if (color.w < 0.0) farol_addRead(s, record, centre, color, false);
#endif
}

// a point light of three; others are left out
void farol_addPoint(inout FarolShading s, const in int record) {
  vec4 centre = farol_lightTexel(record, 0);
  vec3 toLight = centre.xyz - s.positionVS;
  float distanceSquared = dot(toLight, toLight);
  float ratio = distanceSquared / (centre.w * centre.w);
  vec4 color = farol_lightTexel(record, 1);
  if (ratio >= 1.0 || color.w < 0.0) return;
  color.rgb *= farol_boundedAttenuation(distanceSquared, ratio, color.w);
  farol_addLight(s, toLight * inversesqrt(max(distanceSquared, 1e-12)), color.rgb, color.rgb);
}

// directional lights and lights without a range
void farol_addUnbounded(inout FarolShading s) {
  int last = farol_lightCounts.x + farol_lightCounts.y;
  for (int i = 0; i < last; i++) {
    FarolLight light;
    if (i < farol_lightCounts.x) light = farol_directionalLight(i);
    else light = farol_localLight(i, s.positionVS);
    farol_addExtended(s, light);
  }
}
