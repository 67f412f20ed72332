// Gouraud shading, in place of a light loop: sums all lights of the table at the vertices, and interpolates the sums.
// Gouraud 1971, Continuous Shading of Curved Surfaces; thesis 2.2.1.2
#include "shading"
// sums of FarolShading: diffuse, specular, grazing, area (if there are area lights)
varying highp vec3 farol_frontSums[4];
#ifdef DOUBLE_SIDED
varying highp vec3 farol_backSums[4];
#endif
#ifdef FAROL_PER_VERTEX
#ifdef STANDARD
uniform float roughness;
#ifdef IOR
uniform float ior;
#endif
#endif
#ifdef PHONG
uniform float shininess;
#endif
uniform bool receiveShadow;

void farol_addTable(inout FarolShading s) {
  farol_addUnbounded(s);
  int first = farol_lightCounts.x + farol_lightCounts.y;
  for (int i = first; i < first + farol_lightCounts.z; i++) farol_addLocal(s, i);
#ifdef FAROL_AREA_LIGHTS
  if (farol_areaCounts.y > 0 && farol_isPhysical(s)) {
    FarolAreaLobe lobe = FAROL_LOBE_OF(s);
    for (int i = first; i < first + farol_lightCounts.z; i++) farol_addListedArea(s, lobe, i);
  }
#endif
}

void farol_lightVertex(const in vec3 positionVS, const in vec3 normalVS, out vec3 sums[4]) {
  FarolShading s;
  s.positionVS = positionVS;
  s.normalVS = normalVS;
  s.viewDirVS = isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(-positionVS);
  s.dotNV = dot(normalVS, s.viewDirVS);
  s.flags = receiveShadow ? FAROL_RECEIVES_SHADOWS : 0;
#ifdef STANDARD
  s.flags += FAROL_STANDARD;
#ifdef IOR
  float f0 = (ior - 1.0) * (ior - 1.0) / ((ior + 1.0) * (ior + 1.0));
#else
  float f0 = 0.04;
#endif
  farol_setPhysical(s, clamp(roughness, 0.0525, 1.0), f0, 1.0);
#else
  s.flags += FAROL_LAMBERT;
  s.alphaSquared = 0.0;
#ifdef PHONG
  s.alphaSquared = shininess;
#endif
  s.lambdaV = 0.0;
  s.diffuse0 = 1.0;
  s.diffuse90 = 0.0;
#endif
  s.diffuse = s.specular = s.grazing = vec3(0.0);
  farol_addTable(s);
  sums[0] = s.diffuse;
  sums[1] = s.specular;
  sums[2] = s.grazing;
  sums[3] = vec3(0.0);
#if defined( FAROL_AREA_LIGHTS ) && defined( STANDARD )
  sums[3] = s.area;
#endif
}
#else
#ifdef DOUBLE_SIDED
  #define FAROL_VERTEX_SUM(i) (gl_FrontFacing ? farol_frontSums[i] : farol_backSums[i])
#else
  #define FAROL_VERTEX_SUM(i) farol_frontSums[i]
#endif
#if defined( FAROL_AREA_LIGHTS ) && defined( STANDARD )
  #define FAROL_SET_AREA_SUM farol_shading.area = FAROL_VERTEX_SUM(3); \
    farol_shading.dotNV = dot(geometryNormal, geometryViewDir);
#else
  #define FAROL_SET_AREA_SUM
#endif
#if defined( STANDARD )
  #define FAROL_ADD_VERTEX_SUMS \
    reflectedLight.directDiffuse += farol_shading.diffuse * BRDF_Lambert(material.diffuseContribution); \
    reflectedLight.directSpecular += (material.specularColorBlended * (farol_shading.specular - farol_shading.grazing) \
      + material.specularF90 * farol_shading.grazing) * material.multiScatteringCompensation \
      FAROL_AREA_SPECULAR(farol_shading, material.specularColorBlended, material.specularF90, material.roughness);
#elif defined( PHONG )
  #define FAROL_ADD_VERTEX_SUMS \
    reflectedLight.directDiffuse += farol_shading.diffuse * BRDF_Lambert(material.diffuseColor); \
    reflectedLight.directSpecular += (material.specularColor * (farol_shading.specular - farol_shading.grazing) \
      + farol_shading.grazing) * material.specularStrength;
#else
  #define FAROL_ADD_VERTEX_SUMS \
    reflectedLight.directDiffuse += farol_shading.diffuse * BRDF_Lambert(material.diffuseColor);
#endif
#define FAROL_FOR_EACH_LIGHT(positionVS) { \
  FarolShading farol_shading; \
  farol_shading.diffuse = FAROL_VERTEX_SUM(0); \
  farol_shading.specular = FAROL_VERTEX_SUM(1); \
  farol_shading.grazing = FAROL_VERTEX_SUM(2); \
  FAROL_SET_AREA_SUM \
  FAROL_ADD_VERTEX_SUMS \
}
#endif
