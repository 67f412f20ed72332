// The light at the centre of each particle, a texel each: for each colour the sum over all lights, and the sum of
// light times direction, from which the light on a ball or a mesh is computed.
// Farol; Ramamoorthi and Hanrahan 2001 (linear terms)
#include "incidentLight"
#include "lightMask"
uniform highp sampler2D farol_particlePositions; // by slot; xyz: world space (m); w: age (s)
uniform highp sampler2D farol_particleVelocities; // by slot; xyz: m/s; w: life (s)
uniform highp mat4 farol_particleView;
uniform highp mat4 farol_particleProjection;
uniform highp vec4 farol_listPicture; // picture that the light lists cover: xy: first pixel, zw: size (pixels)
uniform bool farol_particlesShadowed;
layout(location = 0) out highp vec4 farol_red;
layout(location = 1) out highp vec4 farol_green;
layout(location = 2) out highp vec4 farol_blue;
vec3 farol_positionVS;

void farol_addParticleLight(const in vec3 color, const in vec3 direction) {
  vec4 facing = vec4(direction, 1.0);
  farol_red += color.r * facing;
  farol_green += color.g * facing;
  farol_blue += color.b * facing;
}

// area light: irradiance of a surface that faces its middle; for a rectangle, in the brightest direction
void farol_addAreaToParticle(const in FarolLight light) {
#ifdef FAROL_AREA_LIGHTS
  vec3 toLight = light.direction * light.distance;
  FarolArea area = farol_areaAt(-light.extension, toLight, light.direction);
  if (area.window <= 0.0) return;
  vec3 direction = light.direction;
  float form;
  if (area.shape == FAROL_AREA_RECTANGLE) {
    vec3 sum = farol_rectangleForm(area.centre, area.halfWidth, area.halfHeight);
    form = length(sum);
    direction = -sum / max(form, 1e-12);
  } else {
    // arbitrary tangents: the cosine lobe is symmetrical
    form = farol_areaDiffuse(farol_toTangentSpace(area, farol_areaLobe(direction, direction, vec4(0.0)).tangents));
  }
  vec3 arriving = farol_masked(light.color, light.mask, toLight, farol_positionVS, direction,
    farol_particlesShadowed);
  farol_addParticleLight(3.1415926536 * form * area.window * arriving, direction);
#endif
}

void farol_shadeParticle(const in FarolLight light) {
  if (light.attenuation <= 0.0) return;
  if (light.extension < 0) {
    farol_addAreaToParticle(light);
    return;
  }
  vec3 color = farol_masked(light.color, light.mask, light.direction * light.distance, farol_positionVS,
    light.direction, farol_particlesShadowed);
  if (light.extension > 0) {
    color *= farol_extensionDiffuse(light.extension);
    vec3 ambient = farol_extensionAmbient(light.extension) * (2.0 * light.attenuation);
    farol_red.w += ambient.r;
    farol_green.w += ambient.g;
    farol_blue.w += ambient.b;
  }
  farol_addParticleLight(color, light.direction);
}
#define FAROL_SHADE(light) farol_shadeParticle(light);
//# main
// In light loops, gl_FragCoord is replaced by a pixel of the picture; FAROL_TEXEL is the particle's texel
ivec2 farol_texel = ivec2(FAROL_TEXEL.xy);
farol_red = farol_green = farol_blue = vec4(0.0);
vec4 farol_center = texelFetch(farol_particlePositions, farol_texel, 0);
if (farol_center.w < texelFetch(farol_particleVelocities, farol_texel, 0).w) {
  vec4 farol_viewed = farol_particleView * vec4(farol_center.xyz, 1.0);
  farol_positionVS = farol_viewed.xyz;
  vec4 farol_clip = farol_particleProjection * farol_viewed;
  vec2 farol_uv = farol_clip.xy / max(farol_clip.w, 1e-6) * 0.5 + 0.5;
  // particles outside of the picture use the light lists at its edge
  vec2 farol_pixel = clamp(farol_uv * farol_listPicture.zw, vec2(0.5), farol_listPicture.zw - 0.5);
  gl_FragCoord.xy = farol_listPicture.xy + farol_pixel;
  FAROL_FOR_EACH_LIGHT(farol_positionVS)
}
