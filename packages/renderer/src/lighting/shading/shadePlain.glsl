// FAROL_SHADE_PLAIN: all lights on a plain MeshStandardMaterial by three sums, in place of an RE_Direct for each light.
// Farol; three.js r187's RE_Direct_Physical
#include "shading"
#if defined( STANDARD ) && ! defined( USE_SPECULAR ) && ! defined( USE_CLEARCOAT ) && ! defined( USE_SHEEN ) \
  && ! defined( USE_IRIDESCENCE ) && ! defined( USE_ANISOTROPY ) && ! defined( USE_DIFFUSE_ROUGHNESS ) \
  && ! defined( USE_RETROREFLECTION )
  #define FAROL_PLAIN_STANDARD
#endif
#ifdef FAROL_VERTEX_NORMAL
  #define FAROL_SET_SHADOW_NORMAL farol_shading.shadowNormalVS = FAROL_SHADOW_NORMAL;
#else
  #define FAROL_SET_SHADOW_NORMAL
#endif
#define FAROL_SHADE_PLAIN \
  FarolShading farol_shading; \
  farol_shading.flags = FAROL_STANDARD + (receiveShadow ? FAROL_RECEIVES_SHADOWS : 0); \
  FAROL_SET_SHADOW_NORMAL \
  farol_shading.positionVS = geometryPosition; \
  farol_shading.normalVS = geometryNormal; \
  farol_shading.viewDirVS = geometryViewDir; \
  farol_shading.dotNV = dot(geometryNormal, geometryViewDir); \
  farol_setPhysical(farol_shading, max(material.roughness, 0.045), material.specularColor.r, material.specularF90); \
  farol_shading.diffuse = farol_shading.specular = farol_shading.grazing = vec3(0.0); \
  farol_addAll(farol_shading); \
  reflectedLight.directDiffuse += farol_shading.diffuse * BRDF_Lambert(material.diffuseContribution); \
  reflectedLight.directSpecular += (material.specularColorBlended * (farol_shading.specular - farol_shading.grazing) \
    + material.specularF90 * farol_shading.grazing) * material.multiScatteringCompensation \
    FAROL_AREA_SPECULAR(farol_shading, material.specularColorBlended, material.specularF90, material.roughness);
