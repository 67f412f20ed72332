// Colours one particle: picture or soft dot, times its light, faded near surfaces and the camera.
// Lorach 2007, Soft Particles (NVIDIA white paper); three.js r187's tone mapping, colour space and clipping
//# stage fragment
#include "media"
#include "storedDistance"
#include "unproject"
#include "viewport"
#include <fog_pars_fragment>
#include <clipping_planes_pars_fragment>
#include <logdepthbuf_pars_fragment>
#ifdef FAROL_MAP
uniform sampler2D farol_particleMap;
#endif
#ifdef FAROL_SOFT
uniform highp sampler2D farol_particleDepth; // depth of opaque surfaces
uniform highp sampler2D farol_particleDistances; // distances of the opaque surfaces, see storedDistance.glsl
uniform highp int farol_particleStored; // stored distances: 0 none, 1 perspective, 2 orthographic
uniform highp vec4 farol_softness; // x: 1 / fading distance (1/m); y: near plane (m); zw: depth texels for each pixel
#endif
uniform highp float farol_hiding; // share of fog's own light: 1, or 0 for additive particles
in highp vec4 farol_particleColor;
in highp vec4 farol_particleUV; // xy, zw: uv in the current and the next picture of the flip book
in highp vec3 farol_particleBall; // xy: position on the particle, -1 to 1; z: share of the next picture, 0 to 1
in highp float farol_particleDistance; // distance along the view (m)
#ifdef FAROL_LIT
#include "particleSurroundings"
flat in highp mat3x4 farol_particleLit;
#endif
//# main
#include <clipping_planes_fragment>
#include <logdepthbuf_fragment>
vec4 farol_color = farol_particleColor;
float farol_radiusSquared = dot(farol_particleBall.xy, farol_particleBall.xy);
#ifdef FAROL_MAP
vec4 farol_picture = texture(farol_particleMap, farol_particleUV.xy);
if (farol_particleBall.z > 0.0) {
  farol_picture = mix(farol_picture, texture(farol_particleMap, farol_particleUV.zw), farol_particleBall.z);
}
farol_color *= farol_picture;
#elif ! defined( FAROL_MESH )
float farol_dot = max(0.0, 1.0 - farol_radiusSquared);
farol_color.a *= farol_dot * farol_dot;
#endif
#if defined( FAROL_LIT ) && ! defined( FAROL_MESH )
float farol_front = sqrt(max(0.0, 1.0 - farol_radiusSquared));
vec4 farol_facing = vec4(normalize(vec3(farol_particleBall.xy, farol_front)), 1.0);
// 1 / 2π: Lambert's 1 / π, halved since a light at 90° counts half
farol_color.rgb *= 0.15915494 * max(vec3(0.0), farol_facing * farol_particleLit)
  + farol_surroundingLight(farol_facing.xyz * mat3(viewMatrix));
#endif
#ifdef FAROL_SOFT
ivec2 farol_pixel = ivec2((gl_FragCoord.xy - farol_offset) * farol_softness.zw);
float farol_surface = texelFetch(farol_particleDepth, farol_pixel, 0).r;
float farol_room = farol_particleDistance - farol_softness.y;
if (!farol_isEmpty(farol_surface)) {
  float farol_away = farol_particleStored == 0 ? -farol_viewZ(farol_surface)
    : farol_unpackDistance(texelFetch(farol_particleDistances, farol_pixel, 0).rg, farol_particleStored == 2);
  farol_room = min(farol_room, farol_away - farol_particleDistance);
}
farol_color.a *= clamp(farol_room * farol_softness.x, 0.0, 1.0);
#endif
#ifdef FAROL_REACTIVE
// pixels covered or brightened by a quarter have no valid history
float farol_brightest = max(1.0, max(farol_color.r, max(farol_color.g, farol_color.b)));
gl_FragColor = vec4(min(1.0, 4.0 * farol_color.a * farol_brightest));
return;
#endif
vec4 farol_between = farol_mediaAt(farol_particleDistance);
farol_color.rgb = farol_color.rgb * farol_between.a + farol_between.rgb * farol_hiding;
gl_FragColor = farol_color;
#include <tonemapping_fragment>
#include <colorspace_fragment>
#ifdef USE_FOG
  #ifdef FOG_EXP2
    float farol_fog = 1.0 - exp(-fogDensity * fogDensity * vFogDepth * vFogDepth);
  #else
    float farol_fog = smoothstep(fogNear, fogFar, vFogDepth);
  #endif
  gl_FragColor.rgb = mix(gl_FragColor.rgb, fogColor * farol_hiding, farol_fog);
#endif
