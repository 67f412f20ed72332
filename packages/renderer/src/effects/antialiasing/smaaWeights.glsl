// SMAA, second step: a pixel's blending weight across each edge: the area between the stepped edge and the line it
// approximates.
// Jimenez et al. 2012, SMAA, 3.2 and 4.2; the area is that of the published AreaTex, computed here
#include "frameSize"
uniform highp sampler2D farol_edgeMap;
layout(location = 0) out highp vec4 farol_weights; // lower edge: x: pixel, y: neighbour; left: z: pixel, w: neighbour

const int FAROL_REACH = 32; // distance that an edge is followed to either side (pixels)

// areas between the edge and a line from a to b (x along the edge, y across), between x and x + 1; x: in the pixel, y:
// in its neighbour across the edge
vec2 farol_areaUnder(const in vec2 a, const in vec2 b, const in float x) {
  if (x + 1.0 <= a.x || x >= b.x) return vec2(0.0);
  float slope = (b.y - a.y) / (b.x - a.x);
  float from = max(x, a.x);
  float to = min(x + 1.0, b.x);
  float y0 = a.y + slope * (from - a.x);
  float y1 = a.y + slope * (to - a.x);
  float width = to - from;
  if (y0 * y1 >= 0.0) {
    float area = 0.5 * (y0 + y1) * width;
    return vec2(max(area, 0.0), max(-area, 0.0));
  }
  float zero = width * y0 / (y0 - y1);
  vec2 triangles = 0.5 * vec2(y0 * zero, y1 * (width - zero));
  return vec2(max(triangles.x, triangles.y), max(-triangles.x, -triangles.y));
}

// areas for lengths of the edge before and after the pixel; first, last: turn of each end: 1 to the pixel's side of the
// edge, -1 to its neighbour's, 0 to no side, 2 to each side
vec2 farol_edgeArea(const in float before, const in float after, const in float first, const in float last) {
  float d = before + after + 1.0;
  float start = first == 2.0 ? (last == 2.0 ? 0.0 : -last) : first;
  float end = last == 2.0 ? (first == 2.0 ? 0.0 : -first) : last;
  if (first == 2.0 && start == 0.0 || last == 2.0 && end == 0.0) return vec2(0.0);
  if (start == 0.0 && end == 0.0) return vec2(0.0);
  if (start * end < 0.0) return farol_areaUnder(vec2(0.0, 0.5 * start), vec2(d, 0.5 * end), before);
  vec2 area1 = start == 0.0 ? vec2(0.0) : farol_areaUnder(vec2(0.0, 0.5 * start), vec2(0.5 * d, 0.0), before);
  vec2 area2 = end == 0.0 ? vec2(0.0) : farol_areaUnder(vec2(0.5 * d, 0.0), vec2(d, 0.5 * end), before);
  if (start == end) { // ends that turn to one side: a short edge is a rounded corner rather than a step
    float straight = min(d / 32.0, 1.0);
    area1 = mix(sqrt(2.0 * area1) * 0.5, area1, straight);
    area2 = mix(sqrt(2.0 * area2) * 0.5, area2, straight);
  }
  return area1 + area2;
}

vec2 farol_edgesAt(const in ivec2 pixel) {
  return any(lessThan(pixel, ivec2(0))) ? vec2(0.0)
    : texelFetch(farol_edgeMap, min(pixel, ivec2(farol_frameSize) - 1), 0).rg;
}

bool farol_isEdge(const in ivec2 pixel, const in int along) {
  return farol_edgesAt(pixel)[along] > 0.5;
}

// Direction in which an edge turns at its end: 1 to the pixel's side, -1 to its neighbour's, 2 to each side, 0 to no
// side. On slanted lines, the edge continues on the next row for the given number of pixels at least. Corners, ends of
// thin lines and crossings do not continue, and are not smoothed: thin lines would fade there.
// own, other: whether a crossing edge goes to the pixel's, the neighbour's side; outside: the pixel beyond the end
float farol_turn(const in bool own, const in bool other, const in ivec2 outside, const in ivec2 over,
  const in ivec2 outwards, const in int along, const in int pixels) {
  bool ownStep = own;
  bool otherStep = other;
  for (int i = 0; i < pixels && (ownStep || otherStep); i++) {
    ownStep = ownStep && farol_isEdge(outside - over + i * outwards, along);
    otherStep = otherStep && farol_isEdge(outside + over + i * outwards, along);
  }
  return ownStep ? (otherStep ? 2.0 : 1.0) : otherStep ? -1.0 : 0.0;
}

// along: 0 the edge below the pixel, 1 the edge at its left
vec2 farol_edgeWeights(const in ivec2 pixel, const in int along) {
  ivec2 step = along == 0 ? ivec2(1, 0) : ivec2(0, 1);
  ivec2 over = along == 0 ? ivec2(0, -1) : ivec2(-1, 0);
  int before = 0;
  int after = 0;
  bvec2 first = bvec2(false); // whether a crossing edge goes to the pixel's side (x), to its neighbour's (y)
  bvec2 last = bvec2(false);
  for (; before <= FAROL_REACH; before++) {
    ivec2 at = pixel - before * step;
    first = bvec2(farol_isEdge(at, along), farol_isEdge(at + over, along));
    if (any(first) || !farol_isEdge(at - step, 1 - along)) break;
  }
  for (; after <= FAROL_REACH; after++) {
    ivec2 at = pixel + (after + 1) * step;
    last = bvec2(farol_isEdge(at, along), farol_isEdge(at + over, along));
    if (any(last) || !farol_isEdge(at, 1 - along)) break;
  }
  int pixels = clamp((before + after + 1) / 3, 1, 4);
  return farol_edgeArea(float(before), float(after),
    farol_turn(first.x, first.y, pixel - (before + 1) * step, over, -step, 1 - along, pixels),
    farol_turn(last.x, last.y, pixel + (after + 1) * step, over, step, 1 - along, pixels));
}
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy);
vec2 edges = texelFetch(farol_edgeMap, pixel, 0).rg;
if (edges.x + edges.y < 0.5) discard;
farol_weights = vec4(0.0);
if (edges.g > 0.5) farol_weights.rg = farol_edgeWeights(pixel, 0);
if (edges.r > 0.5) farol_weights.ba = farol_edgeWeights(pixel, 1);
