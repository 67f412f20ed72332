// Writes a lit material of three into the thin G-buffer: normal, specular lobe, object (thinGBufferLayout.ts).
// Engel 2009, The Light Pre-Pass Renderer (ShaderX7 8.5); Cigolle et al. 2014 (normals)
#include "octahedralNormal"
#include "roundToHalf"
#include "storedDistance"
layout(location = 1) out highp vec4 farol_outDistance;
// normal of shadow look-ups: the vertex normal
#if defined( FAROL_VERTEX_NORMAL ) && ! defined( FLAT_SHADED )
  #define FAROL_THIN_NORMAL vNormal
#else
  #define FAROL_THIN_NORMAL (gl_FrontFacing ? normal : -normal)
#endif
varying highp vec2 farol_object; // x: object number; y: its corner of the 2 × 2 stipple, 0: all texels
#if defined( STANDARD )
  #define FAROL_LOBE (material.specularF90 < 1.0 ? 2.0 + material.roughness : material.roughness)
#elif defined( PHONG )
  #define FAROL_LOBE (-1.0 - material.specularShininess)
#else
  #define FAROL_LOBE 0.0
#endif
#define FAROL_WRITE_THIN farol_outDistance = vec4(farol_packDistance(vViewPosition.z, isOrthographic), \
  farol_roundToHalf(farol_encodeNormal(FAROL_THIN_NORMAL))); \
  gl_FragColor = vec4(farol_roundToHalf(farol_encodeNormal(normal)), FAROL_LOBE, \
  floor(farol_object.x + 0.5) * (receiveShadow ? 1.0 : -1.0));
// a transparent layer writes one texel of each 2 × 2, and none where its alpha is nearly 0
#define FAROL_STIPPLE { \
  ivec2 farol_corner = ivec2(gl_FragCoord.xy) & 1; \
  if (farol_corner.x + 2 * farol_corner.y != int(farol_object.y + 0.5) || gl_FragColor.a < 0.004) discard; \
}
