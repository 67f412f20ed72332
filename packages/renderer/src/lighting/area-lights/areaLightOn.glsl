// Light of rectangles, discs and tubes by linearly transformed cosines; replaces areaLight once a scene has any.
// Heitz et al. 2016, Real-Time Polygonal-Light Shading with Linearly Transformed Cosines; three.js r187
#include "areaForms"
#define FAROL_AREA_LIGHTS
// numbers of lights with a range: x: plain point lights; y: area lights
uniform highp ivec2 farol_areaCounts;

// sets the extension of a FarolLight to that of an area light
#define FAROL_SET_AREA if (farol_lightIsArea(details)) { \
  light.extension = -light.extension; \
  light.color = farol_lightColor(emission); \
  light.attenuation = 1.0; \
  return light; \
}

#define FAROL_PLAIN_LIGHTS farol_areaCounts.x
#define FAROL_OTHER_LIGHTS (farol_lightCounts.w - farol_areaCounts.y)
#define FAROL_SKIP_AREA(details) if (farol_lightIsArea(details)) return;

// members of FarolShading: the specular lobe's transform; sum of colour times the lobe's share that a light fills,
// without Fresnel
#define FAROL_AREA_SUM vec4 ltc; vec3 area;
#define FAROL_BEGIN_AREA_SUM s.ltc = farol_ltcAt(roughness, dotNV, 0.0); s.area = vec3(0.0);
#define FAROL_LOBE_OF(s) farol_areaLobe(s.normalVS, s.viewDirVS, s.ltc)
// extension: record of the area light; only three's physical materials are lit by it, as in three
#define FAROL_AREA_SHADING \
  void farol_addArea(inout FarolShading s, const in FarolAreaLobe lobe, const in int extension, const in vec3 toLight, \
    const in vec3 color, const in int mask) { \
    FarolArea area = farol_areaAt(extension, toLight, s.normalVS); \
    if (area.window <= 0.0) return; \
    vec3 arriving = area.window * farol_masked(color, mask, toLight, s.positionVS, \
      FAROL_SHADOW_NORMAL_OF(s), farol_receivesShadows(s.flags)); \
    area = farol_toTangentSpace(area, lobe.tangents); \
    s.diffuse += 3.1415926536 * farol_areaDiffuse(area) * arriving; \
    s.area += farol_areaSpecular(area, lobe.ltc) * arriving; \
  } \
  void farol_addListedArea(inout FarolShading s, const in FarolAreaLobe lobe, const in int record) { \
    vec4 sphere = farol_lightSphere(record); \
    vec4 emission = farol_lightEmission(record); \
    vec3 toLight = farol_lightPosition(sphere) - s.positionVS; \
    float range = farol_lightRange(sphere); \
    if (farol_lightIsPlain(emission) || dot(toLight, toLight) >= range * range) return; \
    vec4 details = farol_lightDetails(record); \
    if (farol_lightIsArea(details)) FAROL_ADD_LISTED_AREA \
  }
// code for lights with a range (8) and without (16), each only if used: compilers inline it in each call
#if ( FAROL_AREA_KINDS & 8 ) != 0
#define FAROL_ADD_LISTED_AREA farol_addArea(s, lobe, farol_lightExtensionRecord(details), toLight, \
  farol_lightColor(emission), farol_lightMaskRecord(details));
#else
#define FAROL_ADD_LISTED_AREA {}
#endif
#if ( FAROL_AREA_KINDS & 16 ) != 0
#define FAROL_ADD_AREA(light) \
  if (light.extension < 0) { \
    if (farol_isPhysical(s)) \
      farol_addArea(s, FAROL_LOBE_OF(s), -light.extension, light.direction * light.distance, light.color, light.mask); \
    return; \
  }
#else
#define FAROL_ADD_AREA(light)
#endif
#define FAROL_ADD_BOUNDED_AREA(s, record) \
  if (farol_areaCounts.y > 0 && farol_isPhysical(s)) farol_addListedArea(s, FAROL_LOBE_OF(s), record);
#define FAROL_AREA_SPECULAR(s, f0, f90, roughness) + s.area * farol_areaFresnel(f0, f90, roughness, s.dotNV)

// three's RE_Direct_RectArea_Physical, only for physical materials
#ifdef STANDARD
  #define FAROL_BEGIN_AREAS \
    FarolAreaLobe farol_lobe = farol_areaLobe(geometryNormal, geometryViewDir, \
      farol_ltcAt(material.roughness, dot(geometryNormal, geometryViewDir), 0.0)); \
    vec3 farol_areaF = farol_areaFresnel(material.specularColorBlended, material.specularF90, material.roughness, \
      dot(geometryNormal, geometryViewDir)); \
    FAROL_BEGIN_COAT
  #define FAROL_SHADE_AREA(light) \
    if (light.extension < 0) { \
      FarolArea farol_area = farol_areaAt(-light.extension, light.direction * light.distance, geometryNormal); \
      if (farol_area.window > 0.0) { \
        vec3 farol_arriving = farol_area.window * farol_masked(light.color, light.mask, \
          light.direction * light.distance, geometryPosition, FAROL_SHADOW_NORMAL, receiveShadow); \
        FAROL_SHADE_COAT \
        farol_area = farol_toTangentSpace(farol_area, farol_lobe.tangents); \
        reflectedLight.directDiffuse += farol_arriving * material.diffuseContribution * farol_areaDiffuse(farol_area); \
        reflectedLight.directSpecular += farol_arriving * farol_areaF \
          * farol_areaSpecular(farol_area, farol_lobe.ltc); \
      } \
    } else
#else
  #define FAROL_BEGIN_AREAS
  #define FAROL_SHADE_AREA(light) if (light.extension < 0) {} else
#endif
#ifdef USE_CLEARCOAT
  #define FAROL_BEGIN_COAT \
    FarolAreaLobe farol_coatLobe = farol_areaLobe(geometryClearcoatNormal, geometryViewDir, \
      farol_ltcAt(material.clearcoatRoughness, dot(geometryClearcoatNormal, geometryViewDir), 0.0)); \
    vec3 farol_coatF = farol_areaFresnel(material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness, \
      dot(geometryClearcoatNormal, geometryViewDir));
  #define FAROL_SHADE_COAT clearcoatSpecularDirect += farol_arriving * farol_coatF \
    * farol_areaSpecular(farol_toTangentSpace(farol_area, farol_coatLobe.tangents), farol_coatLobe.ltc);
#else
  #define FAROL_BEGIN_COAT
  #define FAROL_SHADE_COAT
#endif
