// Which quads of a tile's list hold any light: a bit a quad, 128 quads a texel.
// Farol
#include "lightTiles"
uniform highp usampler2D farol_tileMask;
layout(location = 0) out highp uvec4 farol_summary;

uint farol_filled(const in int list, const in int start) {
  uint filled = 0u;
  int end = min(start + 32, farol_tiles.w);
  for (int quad = start; quad < end; quad++) {
    if (texelFetch(farol_tileMask, farol_listTexel(list * farol_tiles.w + quad), 0) != uvec4(0u))
      filled |= 1u << uint(quad - start);
  }
  return filled;
}
//# main
int index = int(gl_FragCoord.x) + (int(gl_FragCoord.y) << 11);
int list = index / farol_tileRun.z;
int start = (index - list * farol_tileRun.z) * 128;
farol_summary = uvec4(farol_filled(list, start), farol_filled(list, start + 32), farol_filled(list, start + 64),
  farol_filled(list, start + 96));
