// Share of a lobe that an area light fills. The diffuse lobe is a cosine about z of tangent space, the specular lobe
// a cosine after a linear transform of that space.
// Heitz et al. 2016, Real-Time Polygonal-Light Shading with Linearly Transformed Cosines; three.js r187
#include "areaFeatures"
#include "areaRecord"
#include "discForm"
#include "rectangleForm"
#include "tubeForm"
// 64 × 128 texels, by roughness and sqrt(1 - N·V); lower half: four numbers of the inverse transform; upper half:
// x: weight of F0, y: weight of F90 - F0, w: share of a sphere above the horizon
uniform highp sampler2D farol_ltc;

// An area light relative to a surface point (m).
struct FarolArea {
  int shape;
  vec3 centre;
  vec3 halfWidth;
  vec3 halfHeight;
  float window; // fade by range: 1 up to half the light's reach, 0 from the reach on and behind the light
};

// The diffuse and specular lobes of a surface, as linearly transformed cosines.
struct FarolAreaLobe {
  mat3 tangents; // transform from view space to tangent space
  vec4 ltc; // inverse transform of the specular lobe, from farol_ltcAt(…, 0)
};

// table: 0 for the transform, 1 for Fresnel's weights; do not call in loops whose length differs by pixel, since the
// texture read uses derivatives, as in three
vec4 farol_ltcAt(const in float roughness, const in float dotNV, const in float table) {
  vec2 place = vec2(roughness, sqrt(1.0 - clamp(dotNV, 0.0, 1.0))) * (63.0 / 64.0) + 0.5 / 64.0;
  return texture(farol_ltc, vec2(place.x, 0.5 * (place.y + table)));
}

// tangent space with x along the view; left-handed, as in three
FarolAreaLobe farol_areaLobe(const in vec3 normalVS, const in vec3 viewDirVS, const in vec4 ltc) {
  vec3 across = viewDirVS - normalVS * dot(viewDirVS, normalVS);
  // for a view along the normal, any tangent is right
  if (dot(across, across) < 1e-12)
    across = abs(normalVS.x) < 0.5
      ? vec3(1.0, 0.0, 0.0) - normalVS * normalVS.x
      : vec3(0.0, 1.0, 0.0) - normalVS * normalVS.y;
  vec3 tangent = normalize(across);
  return FarolAreaLobe(transpose(mat3(tangent, -cross(normalVS, tangent), normalVS)), ltc);
}

// view space; toLight: from the surface to the light's centre (m)
FarolArea farol_areaAt(const in int extension, const in vec3 toLight, const in vec3 normalVS) {
  vec4 across = farol_areaAcross(extension);
  vec4 up = farol_areaUp(extension);
  vec3 u = farol_areaHalfWidth(across);
  vec3 v = farol_areaHalfHeight(up);
  FarolArea area = FarolArea(farol_areaShape(across), toLight, u, v, 0.0);
#if ( FAROL_AREA_KINDS & 4 ) != 0 // tubes
  bool isTube = area.shape == FAROL_AREA_TUBE;
#else
  const bool isTube = false;
#endif
  // rectangles and discs light only one side; a surface without a normal (NaN) is not lit
  if (!(dot(normalVS, normalVS) > 0.5) || (!isTube && dot(cross(u, v), toLight) < 0.0)) return area;
  // vector to the nearest point of the light, whose edges are at right angles
  vec2 squared = vec2(dot(u, u), dot(v, v));
  vec2 along = vec2(dot(toLight, u), dot(toLight, v));
  vec2 nearest = clamp(-along / squared, -1.0, 1.0);
  if (isTube) nearest.y = 0.0;
  float away = sqrt(max(dot(toLight, toLight) + dot(nearest, 2.0 * along + nearest * squared), 0.0));
  float x = clamp(2.0 * away / farol_areaReach(up) - 1.0, 0.0, 1.0);
  area.window = 1.0 - x * x * (3.0 - 2.0 * x);
  return area;
}

FarolArea farol_toTangentSpace(const in FarolArea area, const in mat3 tangents) {
  return FarolArea(area.shape, tangents * area.centre, tangents * area.halfWidth, tangents * area.halfHeight,
    area.window);
}

// transform from tangent space to the space in which the specular lobe is a cosine
vec3 farol_toLobe(const in vec4 ltc, const in vec3 v) {
  return vec3(ltc.x * v.x + ltc.z * v.z, v.y, ltc.y * v.x + ltc.w * v.z);
}

#if ( FAROL_AREA_KINDS & 2 ) != 0 // discs
// share of a sphere with the same form factor above the horizon, from three's table
float farol_discShare(const in vec3 centre, const in vec3 u, const in vec3 v) {
  vec2 form = farol_discForm(centre, u, v);
  vec2 place = vec2(form.y * 0.5 + 0.5, form.x) * (63.0 / 64.0) + 0.5 / 64.0;
  return form.x * textureLod(farol_ltc, vec2(place.x, 0.5 * (place.y + 1.0)), 0.0).w;
}
#endif

// share of the cosine lobe that a light fills; area: in tangent space
float farol_areaDiffuse(const in FarolArea area) {
#if ( FAROL_AREA_KINDS & 2 ) != 0 // discs
  if (area.shape == FAROL_AREA_DISC) return farol_discShare(area.centre, area.halfWidth, area.halfHeight);
#endif
#if ( FAROL_AREA_KINDS & 4 ) != 0 // tubes
  if (area.shape == FAROL_AREA_TUBE)
    return farol_tubeForm(area.centre - area.halfWidth, area.centre + area.halfWidth, length(area.halfHeight));
#endif
#if ( FAROL_AREA_KINDS & 1 ) != 0 // rectangles
  if (!farol_isBelowHorizon(area.centre, area.halfWidth, area.halfHeight))
    return farol_aboveHorizon(farol_rectangleForm(area.centre, area.halfWidth, area.halfHeight));
#endif
  return 0.0;
}

// share of the specular lobe that a light fills; area: in tangent space
float farol_areaSpecular(const in FarolArea area, const in vec4 ltc) {
  vec3 centre = farol_toLobe(ltc, area.centre);
  vec3 u = farol_toLobe(ltc, area.halfWidth);
  vec3 v = farol_toLobe(ltc, area.halfHeight);
#if ( FAROL_AREA_KINDS & 2 ) != 0 // discs
  if (area.shape == FAROL_AREA_DISC) return farol_discShare(centre, u, v);
#endif
#if ( FAROL_AREA_KINDS & 4 ) != 0 // tubes
  if (area.shape == FAROL_AREA_TUBE) {
    mat3 m = mat3(ltc.x, 0.0, ltc.y, 0.0, 1.0, 0.0, ltc.z, 0.0, ltc.w);
    float radius = length(area.halfHeight) * farol_tubeWidth(m, area.centre, area.halfWidth);
    return farol_tubeForm(centre - u, centre + u, radius);
  }
#endif
#if ( FAROL_AREA_KINDS & 1 ) != 0 // rectangles
  if (!farol_isBelowHorizon(centre, u, v)) return farol_aboveHorizon(farol_rectangleForm(centre, u, v));
#endif
  return 0.0;
}

// Fresnel factors of an area light: Hill 2016, LTC Fresnel Approximation
vec3 farol_areaFresnel(const in vec3 f0, const in float f90, const in float roughness, const in float dotNV) {
  vec2 weights = farol_ltcAt(roughness, dotNV, 1.0).xy;
  return f0 * weights.x + (f90 - f0) * weights.y;
}
