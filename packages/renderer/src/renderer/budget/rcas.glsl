// Sharpens an enlarged picture as far as its neighbours allow, and writes it with its depth to the host's target.
// FidelityFX Super Resolution 1.0, RCAS: https://github.com/GPUOpen-Effects/FidelityFX-FSR; written anew after it.
// Copyright (c) 2021 Advanced Micro Devices, Inc. All rights reserved. MIT: see licences.md of @farol/renderer.
#include "frameSize"
#include "perceptual"
#include "viewport"
uniform highp sampler2D farol_large; // enlarged picture, encoded by perceptual.glsl
uniform highp sampler2D farol_pictureDepth; // depth of the small picture
uniform highp vec2 farol_scaling; // pixels of the small picture per pixel of the large one
uniform highp vec2 farol_largeSize; // size of the large picture (pixels)
uniform highp float farol_sharpness; // strength, 0 for none to 1 for as much as the neighbours allow
layout(location = 0) out highp vec4 farol_color;

vec4 farol_largeAt(const in ivec2 pixel) {
  return texelFetch(farol_large, clamp(pixel, ivec2(0), ivec2(farol_largeSize) - 1), 0);
}
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy - farol_offset);
vec4 middle = farol_largeAt(pixel);
vec4 below = farol_largeAt(pixel - ivec2(0, 1)), left = farol_largeAt(pixel - ivec2(1, 0));
vec4 right = farol_largeAt(pixel + ivec2(1, 0)), above = farol_largeAt(pixel + ivec2(0, 1));
vec3 least = min(min(below, left), min(right, above)).rgb;
vec3 most = max(max(below, left), max(right, above)).rgb;
// the strongest lobe with which no channel leaves 0 to 1
vec3 hitLeast = least / max(4.0 * most, 1e-5);
vec3 hitMost = (1.0 - most) / min(4.0 * least - 4.0, -1e-5);
vec3 lobes = max(-hitLeast, hitMost);
float lobe = clamp(max(lobes.r, max(lobes.g, lobes.b)), -0.1875, 0.0) * farol_sharpness;
farol_color = farol_fromPerceptual((lobe * (below + left + right + above) + middle) / (4.0 * lobe + 1.0));
ivec2 small = min(ivec2((vec2(pixel) + 0.5) * farol_scaling), ivec2(farol_frameSize) - 1);
gl_FragDepth = texelFetch(farol_pictureDepth, small, 0).r;
