// Distance of the depths of a block of 4 × 4 pixels from a plane through the depths of the block's tile: a flat
// surface's depth is linear over the picture.
// Farol
#include "unproject"
uniform highp sampler2D farol_gDepth;
uniform highp vec2 farol_size;
// floats as bits: x, y: least and greatest distance from the plane (greatest below least: no surface); z, w: slope of
// the plane for a pixel across and up
layout(location = 0) out highp uvec4 farol_plane;

// 1 - depth, or reversed depth: more precise than depths near 1
float farol_preciseDepth(const in float depth) {
  return farol_depthMode.x > 0.0 ? depth : 1.0 - depth;
}
//# main
ivec2 block = ivec2(gl_FragCoord.xy) * 4;
ivec2 first = block & ~(FAROL_TILE - 1);
ivec2 end = ivec2(farol_size);
ivec2 last = min(first + FAROL_TILE, end) - 1;
vec4 corners = vec4(texelFetch(farol_gDepth, first, 0).r, texelFetch(farol_gDepth, ivec2(last.x, first.y), 0).r,
  texelFetch(farol_gDepth, ivec2(first.x, last.y), 0).r, texelFetch(farol_gDepth, last, 0).r);
vec2 slope = vec2(0.0);
if (!farol_isEmpty(corners.x) && !farol_isEmpty(corners.y) && !farol_isEmpty(corners.z) && !farol_isEmpty(corners.w)) {
  vec4 d = vec4(farol_preciseDepth(corners.x), farol_preciseDepth(corners.y), farol_preciseDepth(corners.z),
    farol_preciseDepth(corners.w));
  slope = vec2(d.y + d.w - d.x - d.z, d.z + d.w - d.x - d.y) * 0.5 / vec2(max(last - first, 1));
}
float least = 1e30;
float most = -1e30;
for (int y = 0; y < 4; y++) {
  for (int x = 0; x < 4; x++) {
    ivec2 pixel = min(block + ivec2(x, y), end - 1);
    float depth = texelFetch(farol_gDepth, pixel, 0).r;
    float beside = farol_preciseDepth(depth) - dot(slope, vec2(pixel - first) - float(FAROL_TILE - 1) * 0.5);
    if (farol_isEmpty(depth)) continue;
    least = min(least, beside);
    most = max(most, beside);
  }
}
farol_plane = floatBitsToUint(vec4(least, most, slope));
