// Light volumes over the G-buffer: a pixel's surface, lit, into the lighting buffer.
// Hargreaves and Harris 2004, Deferred Shading; thesis 3.2.3.2
#include "shadeSurface"
uniform vec2 farol_size;
layout(location = 0) out highp vec4 farol_lighting;
#define FAROL_SURFACE_DEPTH(pixel) farol_gDepthAt(pixel)
#define FAROL_IS_EMPTY(pixel, depth) farol_isEmptyPixel(pixel, depth)
#define FAROL_SURFACE_POSITION(pixel, depth) farol_surfacePosition(pixel, depth, farol_size)
#define FAROL_BEGIN_PIXEL FarolShading shading = farol_beginShading(pixel, depth, farol_size);
#define FAROL_UNBOUNDED_PIXEL farol_addUnbounded(shading);
#define FAROL_BOUNDED_PIXEL(record) farol_addBounded(shading, record);
#define FAROL_END_PIXEL farol_lighting = vec4(farol_endShading(shading, pixel), 0.0);
#define FAROL_COUNT_PIXEL(count) farol_lighting = vec4(count, 0.0, 0.0, 0.0);
