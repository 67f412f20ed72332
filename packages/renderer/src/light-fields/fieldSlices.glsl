// Bits of the quads of 128 lights that reach into each of 256 slices of depth, 32 quads a texel.
// Drobot 2017, Improved Culling for Tiled and Clustered Rendering in Call of Duty: Infinite Warfare
#include "lightTiles"
#include "lightSlice"
uniform highp sampler2D farol_boxLows;
layout(location = 0) out highp uvec4 farol_slice;
//# main
ivec2 at = ivec2(gl_FragCoord.xy);
// range of this slice, widened by rounding errors; the outer slices extend to infinity
float from = at.x == 0 ? -1e30 : float(at.x) - 0.05;
float to = at.x == 255 ? 1e30 : float(at.x) + 1.05;
uint bits = 0u;
int last = min(32, farol_tiles.w - at.y * 32);
for (int i = 0; i < last; i++) {
  for (int box = 0; box < 4; box++) {
    vec4 low = texelFetch(farol_boxLows, ivec2(box, at.y * 32 + i), 0);
    if (low.x < 1e29 && farol_slicePlace(-low.z) >= from && farol_slicePlace(-low.w) <= to) bits |= 1u << uint(i);
  }
}
farol_slice = uvec4(bits);
