// Writes a lit material of three into the G-buffer; layout in gbuffer/gbufferLayout.ts.
// Valient, Deferred Rendering in Killzone 2, 2007; Cigolle et al. 2014 (normals)
#include "halfNormal"
#include "octahedralNormal"
#include "roundToHalf"
#include "storedDistance"
#include "surfaceFlags"
uniform bool farol_lite; // whether to write the layout of the quality 'lite'
#if defined( STANDARD )
  #define FAROL_WRITE_MATERIAL farol_outMaterial = vec4(material.roughness, material.metalness, \
    sqrt(material.specularColor.r), material.specularF90); gl_FragColor.a = 1.0;
#elif defined( PHONG )
  #define FAROL_WRITE_MATERIAL farol_outMaterial = farol_lite \
    ? vec4(sqrt(material.specularColor.r * material.specularStrength), \
      log2(1.0 + material.specularShininess) / 13.0, 0.0, 0.0) \
    : vec4(sqrt(material.specularColor), material.specularStrength); \
    gl_FragColor.a = material.specularShininess;
#else
  #define FAROL_WRITE_MATERIAL farol_outMaterial = vec4(1.0, 0.0, 0.0, 0.0); gl_FragColor.a = 1.0;
#endif
// vertex normal for shadow look-ups, if a normal map or back face changes the shaded normal; not stored in 'lite'
#if ( defined( USE_NORMALMAP ) || defined( USE_BUMPMAP ) ) && defined( FAROL_VERTEX_NORMAL ) \
  && ! defined( FLAT_SHADED ) && ! defined( PHONG )
  #define FAROL_NORMAL_FLAG (farol_lite ? 0 : FAROL_HAS_VERTEX_NORMAL)
  #define FAROL_WRITE_VERTEX_NORMAL if (receiveShadow) gl_FragColor.a = farol_packNormal(vNormal);
#elif defined( DOUBLE_SIDED )
  #define FAROL_NORMAL_FLAG (gl_FrontFacing ? 0 : FAROL_IS_REVERSED)
#else
  #define FAROL_NORMAL_FLAG 0
#endif
#ifndef FAROL_WRITE_VERTEX_NORMAL
  #define FAROL_WRITE_VERTEX_NORMAL
#endif
#define FAROL_WRITE_GBUFFER \
  farol_outNormal = \
    vec4(farol_roundToHalf(farol_encodeNormal(normal)), farol_packDistance(vViewPosition.z, isOrthographic)); \
  farol_outAlbedo = vec4(sqrt(material.diffuseColor), \
    farol_packFlags(FAROL_FLAGS + (receiveShadow ? FAROL_RECEIVES_SHADOWS + FAROL_NORMAL_FLAG : 0))); \
  FAROL_WRITE_MATERIAL FAROL_WRITE_VERTEX_NORMAL
