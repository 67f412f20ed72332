// View z of a pixel's surface, from depth, or from a stored distance where depth is offset, oblique or imprecise.
// Farol
#include "frameSize"
#include "storedDistance"
#include "unproject"
uniform highp sampler2D farol_surfaceDepth;
uniform highp sampler2D farol_surfaceDistance; // distance of the surface, as two half floats: storedDistance.glsl
// x: stored distances: 0 none, 1 perspective, 2 orthographic; y: first component of the distance, 0 or 2
uniform highp ivec2 farol_surfaceStored;

// view-space z of a pixel's surface (m), negative before the camera; 0 outside of the picture
float farol_surfaceZ(const in ivec2 pixel) {
  if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, ivec2(farol_frameSize)))) return 0.0;
  if (farol_surfaceStored.x == 0) return farol_viewZ(texelFetch(farol_surfaceDepth, pixel, 0).r);
  vec4 stored = texelFetch(farol_surfaceDistance, pixel, 0);
  return -farol_unpackDistance(farol_surfaceStored.y == 0 ? stored.xy : stored.zw, farol_surfaceStored.x == 2);
}
