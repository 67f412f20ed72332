// Light that each froxel scatters to the eye per metre, and its extinction, averaged with earlier frames'.
// Wronski 2014, Volumetric Fog
#include "ambientLight"
#include "incidentLight"
#include "lightMask"
#include "fogMedium"
#include "fogPhase"
#include "fogSlices"
uniform highp usampler2D farol_fogLights; // bits of lights, see fogLights.glsl
uniform highp ivec2 farol_fogBlocks; // number of blocks of froxels across and up
uniform highp sampler3D farol_fogBefore; // froxels of the last frame
uniform highp mat4 farol_fogToWorld; // from view space to world space
uniform highp mat4 farol_fogToBefore; // from view space to the last frame's view space
uniform highp vec4 farol_fogRayBefore; // last frame's projection: xy scale, zw shift
uniform highp vec4 farol_fogShare; // xyz: sample position in the froxel (-0.5 to 0.5); w: share of this frame
// x: number of slices of which one is computed in a frame; y: index of that slice among them
uniform highp ivec2 farol_fogTurn;
uniform highp float farol_fogOtherShare; // share of the computed slice in the other slices
uniform highp float farol_anisotropy;
layout(location = 0) out highp vec4 farol_froxel0;
layout(location = 1) out highp vec4 farol_froxel1;
layout(location = 2) out highp vec4 farol_froxel2;
layout(location = 3) out highp vec4 farol_froxel3;
#if FAROL_FOG_LAYERS > 4
layout(location = 4) out highp vec4 farol_froxel4;
layout(location = 5) out highp vec4 farol_froxel5;
layout(location = 6) out highp vec4 farol_froxel6;
layout(location = 7) out highp vec4 farol_froxel7;
#endif
// view-space point (m) whose light is summed, and the sums
vec3 farol_fogPosition;
vec3 farol_fogView; // direction from the eye, unit length
vec3 farol_fogLight;

// area light: irradiance of a surface that faces its middle; for a rectangle, in the brightest direction
void farol_addAreaToFog(const in FarolLight light) {
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
    form = farol_areaDiffuse(farol_toTangentSpace(area, farol_areaLobe(direction, direction, vec4(0.0)).tangents));
  }
  vec3 arriving = farol_masked(light.color, light.mask, toLight, farol_fogPosition, direction, true);
  farol_fogLight += 3.1415926536 * form * area.window * arriving
    * farol_phase(dot(direction, farol_fogView), farol_anisotropy);
#endif
}

void farol_addToFog(const in FarolLight light) {
  if (light.attenuation <= 0.0) return;
  if (light.extension < 0) {
    farol_addAreaToFog(light);
    return;
  }
  vec3 color = farol_masked(light.color, light.mask, light.direction * light.distance, farol_fogPosition,
    light.direction, true);
  if (light.extension > 0) color *= farol_extensionDiffuse(light.extension);
  farol_fogLight += color * farol_phase(dot(light.direction, farol_fogView), farol_anisotropy);
}

// light that a froxel scatters in this frame, and its extinction
vec4 farol_scatteredAt(const in int slice) {
  vec2 size = vec2(farol_fogGrid.xy);
  vec2 place = (gl_FragCoord.xy + farol_fogShare.xy) / size;
  float depth = farol_fogDepth(float(slice) + 0.5 + farol_fogShare.z);
  farol_fogPosition = farol_fogRayAt(place) * depth;
  vec4 medium = farol_mediumAt((farol_fogToWorld * vec4(farol_fogPosition, 1.0)).xyz);
  vec4 froxel = vec4(0.0, 0.0, 0.0, medium.a);
  if (medium.a > 0.0) {
    farol_fogView = normalize(farol_fogPosition);
    // radiance of ambient light: its mean, and the part of its slope that the phase function keeps
    farol_fogLight = max(vec3(0.0), 0.3183098862 * farol_ambient
      + 0.4774648293 * farol_anisotropy * (farol_ambientSlopes * farol_fogView));
    int first = farol_lightCounts.x + farol_lightCounts.y;
    for (int i = 0; i < first; i++) farol_addToFog(farol_lightAt(i, farol_fogPosition));
    ivec2 block = ivec2(gl_FragCoord.xy) >> 3;
    block.x += (slice >> 2) * farol_fogBlocks.x;
    for (int quad = 0; quad * 128 < farol_lightCounts.z; quad++) {
      uvec4 words = texelFetch(farol_fogLights, block, 0);
      block.y += farol_fogBlocks.y;
      for (int word = 0; word < 4; word++) {
        uint bits = word < 2 ? (word == 0 ? words.x : words.y) : word == 2 ? words.z : words.w;
        int record = first + quad * 128 + word * 32;
        for (; bits != 0u; bits >>= 1, record++)
          if ((bits & 1u) != 0u) farol_addToFog(farol_localLight(record, farol_fogPosition));
      }
    }
    froxel.rgb = min(medium.rgb * farol_fogLight, 60000.0);
  }
  return froxel;
}

// a froxel averaged with earlier frames' at its position
vec4 farol_joined(const in int slice, const in vec4 froxel, const in float share) {
  if (share < 1.0) {
    vec3 middle = farol_fogRayAt(gl_FragCoord.xy / vec2(farol_fogGrid.xy)) * farol_fogDepth(float(slice) + 0.5);
    vec3 before = (farol_fogToBefore * vec4(middle, 1.0)).xyz;
    vec3 at = vec3((before.xy * farol_fogRayBefore.xy / -before.z - farol_fogRayBefore.zw) * 0.5 + 0.5,
      log(1.0 + max(-before.z, 0.0) / farol_fogSlices.x) / farol_fogSlices.y);
    if (before.z < 0.0 && all(greaterThanEqual(at, vec3(0.0))) && all(lessThanEqual(at, vec3(1.0))))
      return mix(texture(farol_fogBefore, at), froxel, share);
  }
  return froxel;
}
//# main
vec4 lit;
// a loop, since eight inlined copies of the function would compile slowly
for (int i = 0; i < FAROL_FOG_LAYERS; i++) {
  int slice = farol_fogGrid.w + i;
  int place = i % farol_fogTurn.x;
  if (place == 0) lit = farol_scatteredAt(slice + farol_fogTurn.y);
  vec4 froxel = farol_joined(slice, lit, place == farol_fogTurn.y ? farol_fogShare.w : farol_fogOtherShare);
  if (i == 0) farol_froxel0 = froxel;
  else if (i == 1) farol_froxel1 = froxel;
  else if (i == 2) farol_froxel2 = froxel;
  else if (i == 3) farol_froxel3 = froxel;
#if FAROL_FOG_LAYERS > 4
  else if (i == 4) farol_froxel4 = froxel;
  else if (i == 5) farol_froxel5 = froxel;
  else if (i == 6) farol_froxel6 = froxel;
  else farol_froxel7 = froxel;
#endif
}
