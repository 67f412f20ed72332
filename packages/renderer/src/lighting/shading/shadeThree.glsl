// FAROL_SHADE for three's lit materials: fills IncidentLight, calls RE_Direct, applies a light's specular and ambient.
// Farol; three's lights_fragment_begin
#include "areaLight"
#include "lightMask"
#ifdef STANDARD
  #define FAROL_DIFFUSE_COLOR material.diffuseContribution
#else
  #define FAROL_DIFFUSE_COLOR material.diffuseColor
#endif
#ifndef FAROL_AMBIENT_FACTOR
  #define FAROL_AMBIENT_FACTOR 1.0
#endif
#ifdef USE_CLEARCOAT
  #define FAROL_SAVE_CLEARCOAT vec3 farol_clearcoat = clearcoatSpecularDirect;
  #define FAROL_SCALE_CLEARCOAT clearcoatSpecularDirect = mix(farol_clearcoat, clearcoatSpecularDirect, \
    farol_specular);
#else
  #define FAROL_SAVE_CLEARCOAT
  #define FAROL_SCALE_CLEARCOAT
#endif
#ifdef USE_SHEEN
  #define FAROL_SAVE_SHEEN vec3 farol_sheen = sheenSpecularDirect;
  #define FAROL_SCALE_SHEEN sheenSpecularDirect = mix(farol_sheen, sheenSpecularDirect, farol_specular);
#else
  #define FAROL_SAVE_SHEEN
  #define FAROL_SCALE_SHEEN
#endif
// skips unlit surfaces, except with three's toon shading, whose derivatives need all pixels
#if defined( TOON ) && ! defined( FAROL_TOON )
  #define FAROL_IS_LIT(light) true
#else
  #define FAROL_IS_LIT(light) light.attenuation > 0.0
#endif
#ifdef FAROL_TOON
  #define FAROL_DIRECT(light) reflectedLight.directDiffuse += farol_toonGradient(light, geometryNormal) \
    * directLight.color * BRDF_Lambert(material.diffuseColor);
#else
  #define FAROL_DIRECT(light) RE_Direct(directLight, geometryPosition, geometryNormal, geometryViewDir, \
    geometryClearcoatNormal, material, reflectedLight);
#endif
// normal along which shadow look-ups are offset: the interpolated vertex normal, as in three
#if defined( FAROL_VERTEX_NORMAL ) && !defined( FLAT_SHADED )
  #define FAROL_SHADOW_NORMAL vNormal
#elif defined( FLAT_SHADED )
  #define FAROL_SHADOW_NORMAL (gl_FrontFacing ? geometryNormal : -geometryNormal)
#else
  #define FAROL_SHADOW_NORMAL geometryNormal
#endif
#define FAROL_SHADE(light) \
  farol_lightsEvaluated += 1.0; \
  FAROL_SHADE_AREA(light) \
  if (FAROL_IS_LIT(light)) { \
  directLight.direction = light.direction; \
    directLight.color = farol_masked(light.color, light.mask, light.direction * light.distance, geometryPosition, \
    FAROL_SHADOW_NORMAL, receiveShadow); directLight.visible = true; \
  ReflectedLight farol_before = reflectedLight; FAROL_SAVE_CLEARCOAT FAROL_SAVE_SHEEN \
  FAROL_DIRECT(light) \
  if (light.extension > 0) { \
    vec3 farol_diffuse = farol_extensionDiffuse(light.extension); \
    vec3 farol_specular = farol_extensionSpecular(light.extension); \
    reflectedLight.directDiffuse = mix(farol_before.directDiffuse, reflectedLight.directDiffuse, farol_diffuse) \
      + farol_extensionAmbient(light.extension) * light.attenuation * FAROL_AMBIENT_FACTOR \
      * BRDF_Lambert(FAROL_DIFFUSE_COLOR); \
    reflectedLight.directSpecular = mix(farol_before.directSpecular, reflectedLight.directSpecular, \
      farol_specular); \
    FAROL_SCALE_CLEARCOAT FAROL_SCALE_SHEEN \
  } }
