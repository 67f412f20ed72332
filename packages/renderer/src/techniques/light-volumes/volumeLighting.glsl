// Light volumes over the G-buffer: reads a pixel's surface, lights it, writes to the lighting buffer.
// Hargreaves and Harris 2004, Deferred Shading; thesis 3.2.3.2
#include "shadeSurface"
uniform vec2 farol_size;
layout(location = 0) out highp vec4 farol_lighting;
#define FarolPixel FarolShading

float farol_pixelDepth(const in ivec2 pixel) {
  return farol_gDepthAt(pixel);
}

bool farol_isPixelEmpty(const in ivec2 pixel, const in float depth) {
  return farol_isEmptyPixel(pixel, depth);
}

// view space, m
vec3 farol_pixelPosition(const in ivec2 pixel, const in float depth) {
  return farol_surfacePosition(pixel, depth, farol_size);
}

FarolPixel farol_beginPixel(const in ivec2 pixel, const in float depth) {
  return farol_beginShading(pixel, depth, farol_size);
}

vec3 farol_pixelNormal(const in FarolPixel lit) {
  return lit.normalVS;
}

void farol_addUnboundedToPixel(inout FarolPixel lit) {
  farol_addUnbounded(lit);
}

// record: a light with a range
void farol_addToPixel(inout FarolPixel lit, const in int record) {
  farol_addLocal(lit, record);
  FAROL_ADD_BOUNDED_AREA(lit, record)
}

void farol_endPixel(const in FarolPixel lit, const in ivec2 pixel) {
  farol_lighting = vec4(farol_endShading(lit, pixel), 0.0);
}

void farol_countPixel(const in float count) {
  farol_lighting = vec4(count, 0.0, 0.0, 0.0);
}
