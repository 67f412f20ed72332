// A decal at a pixel's surface: its colour and opacity there, and the surface below.
// Krishnan 2012; Persson 2011, Volume Decals (GPU Pro 2); Wronski 2015 (gradients from the same surface)
#include "frameSize"
#include "unproject"
#include "octahedralNormal"
#include "storedDistance"
#include "surfaceFlags"
uniform highp sampler2D farol_surfaceDepth;
uniform highp sampler2D farol_surfaceNormal; // G-buffer; xy: normal (octahedral, view space); zw: stored distance
uniform highp int farol_surfaceStored; // stored distances: 0 none, 1 perspective, 2 orthographic
uniform lowp sampler2D farol_surfaceAlbedo; // rgb: square root of the albedo; a: flags / 255
uniform sampler2D farol_decalMap;
uniform sampler2D farol_decalNormalMap;
uniform highp mat4 farol_decalInverse; // matrix from view space (m) to the decal's unit box
uniform highp mat4 modelViewMatrix;
uniform vec4 farol_decalColor; // the decal's linear colour, and opacity, 0 to 1
uniform mat3 farol_decalMapTransform;
uniform mat3 farol_decalNormalMapTransform;
uniform vec4 farol_decalValues; // x: roughness; y: metalness; zw: normal scale, z above 1e8: no normal map
uniform int farol_decalBlending; // three's blending constant: 1 normal, 2 additive, 3 subtractive, 4 multiply
uniform float farol_decalFacing; // cosine of the largest angle between surface normal and decal axis

struct FarolDecal {
  vec3 color; // linear colour of the decal
  float opacity; // opacity of the decal, above 0 to 1
  vec3 blended; // albedo of the surface with the decal blended over it, linear, 0 to 1
  vec3 normal; // normal of the surface, view space
  vec3 albedo; // albedo of the surface and of decals already on it, linear
  int flags; // flags of the surface, see surfaceFlags.glsl
  vec2 uv;
  vec2 across; // change of the texture coordinates to the next pixel in x
  vec2 up;
};

vec3 farol_inDecal(const in ivec2 pixel) {
  ivec2 size = ivec2(farol_frameSize);
  ivec2 at = clamp(pixel, ivec2(0), size - 1);
  float z = farol_surfaceStored == 0
    ? farol_viewZ(texelFetch(farol_surfaceDepth, at, 0).r)
    : -farol_unpackDistance(texelFetch(farol_surfaceNormal, at, 0).zw, farol_surfaceStored == 2);
  vec3 position = farol_unprojectAt((vec2(at) + 0.5) / vec2(size), z);
  return (farol_decalInverse * vec4(position, 1.0)).xyz;
}

vec2 farol_smaller(const in vec3 a, const in vec3 b) {
  return dot(a, a) < dot(b, b) ? a.xy : b.xy;
}

// blends a decal over the surface below as three does with premultiplied alpha
vec3 farol_blend(const in vec3 below, const in vec3 color, const in float opacity) {
  if (farol_decalBlending == 2) return below + color;
  if (farol_decalBlending == 3) return below * (1.0 - color);
  if (farol_decalBlending == 4) return below * (color + 1.0 - opacity);
  return color + below * (1.0 - opacity);
}

// false outside of the decal's box, on surfaces turned too far from its axis, or where the decal is transparent
bool farol_findDecal(const in ivec2 pixel, out FarolDecal decal) {
  if (farol_isEmpty(texelFetch(farol_surfaceDepth, pixel, 0).r)) return false;
  vec3 place = farol_inDecal(pixel);
  if (any(greaterThan(abs(place), vec3(0.5)))) return false;
  decal.normal = farol_decodeNormal(texelFetch(farol_surfaceNormal, pixel, 0).xy);
  if (dot(decal.normal, normalize(modelViewMatrix[2].xyz)) <= farol_decalFacing) return false;
  decal.uv = place.xy + 0.5;
  decal.across = farol_smaller(farol_inDecal(pixel + ivec2(1, 0)) - place, place - farol_inDecal(pixel - ivec2(1, 0)));
  decal.up = farol_smaller(farol_inDecal(pixel + ivec2(0, 1)) - place, place - farol_inDecal(pixel - ivec2(0, 1)));
  mat2 linear = mat2(farol_decalMapTransform);
  vec4 color = textureGrad(farol_decalMap, (farol_decalMapTransform * vec3(decal.uv, 1.0)).xy, linear * decal.across,
    linear * decal.up);
  color *= farol_decalColor;
  decal.color = color.rgb;
  decal.opacity = color.a;
  vec4 albedo = texelFetch(farol_surfaceAlbedo, pixel, 0);
  decal.albedo = albedo.rgb * albedo.rgb;
  decal.blended = clamp(farol_blend(decal.albedo, color.rgb * color.a, color.a), 0.0, 1.0);
  decal.flags = farol_unpackFlags(albedo.a);
  return decal.opacity > 0.0;
}
