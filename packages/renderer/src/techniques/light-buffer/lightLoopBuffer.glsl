// In place of a light loop: the light buffer's sums at this pixel, multiplied by the material's colours.
// Engel 2009, The Light Pre-Pass Renderer (ShaderX7 8.5); Kircher and Lawrance 2009, Inferred Lighting
#include "lightBufferFilter"
#ifdef USE_IRIDESCENCE
  #define FAROL_SPECULAR(sums) mix(material.specularColorBlended * sums.specularF0 \
    + material.specularF90 * sums.specularF90, material.iridescenceFresnel * (sums.specularF0 + sums.specularF90), \
    material.iridescence)
#else
  #define FAROL_SPECULAR(sums) (material.specularColorBlended * sums.specularF0 \
    + material.specularF90 * sums.specularF90)
#endif
#ifdef FAROL_AREA_LIGHTS
  #define FAROL_ADD_AREA_SUM(sums) reflectedLight.directSpecular += sums.area * farol_areaFresnel( \
    material.specularColorBlended, material.specularF90, material.roughness, dot(geometryNormal, geometryViewDir));
#else
  #define FAROL_ADD_AREA_SUM(sums)
#endif
#if defined( STANDARD )
  #define FAROL_ADD_SUMS(sums) \
    reflectedLight.directDiffuse += BRDF_Lambert(material.diffuseContribution) \
      * ((1.0 - material.specularColor) * sums.diffuse \
      + (material.specularF90 < 1.0 ? 1.0 - material.specularF90 : 1.0) * sums.rest); \
    reflectedLight.directSpecular += FAROL_SPECULAR(sums) * material.multiScatteringCompensation; \
    FAROL_ADD_AREA_SUM(sums)
#elif defined( PHONG )
  #define FAROL_ADD_SUMS(sums) \
    reflectedLight.directDiffuse += BRDF_Lambert(material.diffuseColor) * sums.diffuse; \
    reflectedLight.directSpecular += (material.specularColor * sums.specularF0 + sums.specularF90) \
      * material.specularStrength;
#else
  #define FAROL_ADD_SUMS(sums) reflectedLight.directDiffuse += BRDF_Lambert(material.diffuseColor) * sums.diffuse;
#endif
#define FAROL_FOR_EACH_LIGHT(positionVS) { \
  FarolLightSums farol_sums = farol_lightSums(positionVS, geometryNormal); \
  farol_lightsEvaluated += farol_sums.diffuse.r * farol_lightGrid.x * farol_lightGrid.y \
    * (farol_object.y > 0.5 ? 0.25 : 1.0); \
  FAROL_ADD_SUMS(farol_sums) \
}
