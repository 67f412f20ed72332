// Enlarges a picture along its edges: sixteen pixels round a place, weighted by a kernel that an edge stretches.
// AMD's kernel leaves out corner pixels and stretches less: at scales from 0.7 on, up to 0.7 dB farther from full size.
// FidelityFX Super Resolution 1.0, EASU: https://github.com/GPUOpen-Effects/FidelityFX-FSR; written anew after it.
// Copyright (c) 2021 Advanced Micro Devices, Inc. All rights reserved. MIT: see licences.md of @farol/renderer.
#include "frameSize"
#include "perceptual"
#include "viewport"
uniform highp sampler2D farol_picture;
uniform highp vec2 farol_scaling; // pixels of the small picture per pixel of the large one
layout(location = 0) out highp vec4 farol_color;

/** Direction and length of the edge at a place: sums over the four pixels round it. */
struct FarolEdge {
  vec2 direction;
  float length;
};

vec4 farol_smallAt(const in ivec2 pixel) {
  return farol_toPerceptual(texelFetch(farol_picture, clamp(pixel, ivec2(0), ivec2(farol_frameSize) - 1), 0));
}

float farol_lumaOf(const in vec4 c) {
  return 0.5 * (c.r + c.b) + c.g;
}

// straightness of luma across three pixels: 1 on a steady slope, 0 at a peak or trough
float farol_straight(const in float before, const in float middle, const in float after) {
  float straight = abs(after - before) / max(max(abs(after - middle), abs(middle - before)), 1e-5);
  straight = clamp(straight, 0.0, 1.0);
  return straight * straight;
}

// adds one of the four pixels, from its luma and its neighbours' lumas
void farol_addPixel(inout FarolEdge edge, const in float weight, const in float below, const in float left,
  const in float middle, const in float right, const in float above) {
  edge.direction += weight * vec2(right - left, above - below);
  edge.length += weight * (farol_straight(left, middle, right) + farol_straight(below, middle, above));
}

// adds a pixel to the sum; off: its offset from the place (pixels), lobe: strength of the kernel's negative lobe
void farol_addTap(inout vec4 sum, inout float total, const in vec2 off, const in vec2 direction, const in vec2 stretch,
  const in float lobe, const in vec4 color) {
  vec2 v = vec2(dot(off, direction), dot(off, vec2(-direction.y, direction.x))) * stretch;
  float squared = min(dot(v, v), 1.0 / lobe);
  // Lanczos's kernel of two lobes, without sines
  float base = 0.4 * squared - 1.0;
  float window = lobe * squared - 1.0;
  float weight = (25.0 / 16.0 * base * base - (25.0 / 16.0 - 1.0)) * window * window;
  sum += color * weight;
  total += weight;
}
//# main
vec2 place = (gl_FragCoord.xy - farol_offset) * farol_scaling - 0.5;
ivec2 f = ivec2(floor(place));
vec2 part = place - vec2(f);
// m n o p (names of the sixteen pixels)
// i j k l
// e f g h
// a b c d
vec4 b = farol_smallAt(f + ivec2(0, -1)), c = farol_smallAt(f + ivec2(1, -1));
vec4 e = farol_smallAt(f + ivec2(-1, 0)), ff = farol_smallAt(f), g = farol_smallAt(f + ivec2(1, 0));
vec4 h = farol_smallAt(f + ivec2(2, 0)), i = farol_smallAt(f + ivec2(-1, 1)), j = farol_smallAt(f + ivec2(0, 1));
vec4 k = farol_smallAt(f + ivec2(1, 1)), l = farol_smallAt(f + ivec2(2, 1));
vec4 n = farol_smallAt(f + ivec2(0, 2)), o = farol_smallAt(f + ivec2(1, 2));
float fL = farol_lumaOf(ff), gL = farol_lumaOf(g), jL = farol_lumaOf(j), kL = farol_lumaOf(k);
FarolEdge edge = FarolEdge(vec2(0.0), 0.0);
farol_addPixel(edge, (1.0 - part.x) * (1.0 - part.y), farol_lumaOf(b), farol_lumaOf(e), fL, gL, jL);
farol_addPixel(edge, part.x * (1.0 - part.y), farol_lumaOf(c), fL, gL, farol_lumaOf(h), kL);
farol_addPixel(edge, (1.0 - part.x) * part.y, fL, farol_lumaOf(i), jL, kL, farol_lumaOf(n));
farol_addPixel(edge, part.x * part.y, gL, jL, kL, farol_lumaOf(l), farol_lumaOf(o));
float steep = dot(edge.direction, edge.direction);
vec2 direction = steep < 1.0 / 32768.0 ? vec2(1.0, 0.0) : edge.direction * inversesqrt(steep);
float along = min(edge.length * edge.length, 1.0);
// up to √2 at 45 degrees, where pixels are farther apart
float diagonal = 1.0 / max(abs(direction.x), abs(direction.y));
vec2 stretch = vec2(1.0 + (diagonal - 1.0) * along, 1.0 - 0.5 * along);
float lobe = mix(0.47, 0.24, along);
vec4 sum = vec4(0.0);
float total = 0.0;
farol_addTap(sum, total, vec2(0.0, -1.0) - part, direction, stretch, lobe, b);
farol_addTap(sum, total, vec2(1.0, -1.0) - part, direction, stretch, lobe, c);
farol_addTap(sum, total, vec2(-1.0, 0.0) - part, direction, stretch, lobe, e);
farol_addTap(sum, total, -part, direction, stretch, lobe, ff);
farol_addTap(sum, total, vec2(1.0, 0.0) - part, direction, stretch, lobe, g);
farol_addTap(sum, total, vec2(2.0, 0.0) - part, direction, stretch, lobe, h);
farol_addTap(sum, total, vec2(-1.0, 1.0) - part, direction, stretch, lobe, i);
farol_addTap(sum, total, vec2(0.0, 1.0) - part, direction, stretch, lobe, j);
farol_addTap(sum, total, vec2(1.0, 1.0) - part, direction, stretch, lobe, k);
farol_addTap(sum, total, vec2(2.0, 1.0) - part, direction, stretch, lobe, l);
farol_addTap(sum, total, vec2(0.0, 2.0) - part, direction, stretch, lobe, n);
farol_addTap(sum, total, vec2(1.0, 2.0) - part, direction, stretch, lobe, o);
farol_addTap(sum, total, vec2(-1.0, -1.0) - part, direction, stretch, lobe, farol_smallAt(f + ivec2(-1, -1)));
farol_addTap(sum, total, vec2(2.0, -1.0) - part, direction, stretch, lobe, farol_smallAt(f + ivec2(2, -1)));
farol_addTap(sum, total, vec2(-1.0, 2.0) - part, direction, stretch, lobe, farol_smallAt(f + ivec2(-1, 2)));
farol_addTap(sum, total, vec2(2.0, 2.0) - part, direction, stretch, lobe, farol_smallAt(f + ivec2(2, 2)));
// clamped to the four pixels' range, so that edges do not ring
farol_color = clamp(sum / total, min(min(ff, g), min(j, k)), max(max(ff, g), max(j, k)));
