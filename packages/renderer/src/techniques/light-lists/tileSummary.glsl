// Bits of the quads of a tile's list that hold any light, 128 quads a texel.
// Farol
#include "lightTiles"
uniform highp usampler2D farol_tileMask;
layout(location = 0) out highp uvec4 farol_summary;

uint farol_filled(const in ivec2 tile, const in int start) {
  uint filled = 0u;
  int end = min(start + 32, farol_tiles.w);
  for (int quad = start; quad < end; quad++) {
    if (texelFetch(farol_tileMask, farol_listTexel(tile, farol_tiles.yz, quad), 0) != uvec4(0u))
      filled |= 1u << uint(quad - start);
  }
  return filled;
}
//# main
ivec2 at = ivec2(gl_FragCoord.xy);
ivec2 place = at / farol_tiles.yz;
ivec2 tile = at - place * farol_tiles.yz;
int start = (place.x + (place.y << farol_tiles.x)) * 128;
farol_summary = uvec4(farol_filled(tile, start), farol_filled(tile, start + 32), farol_filled(tile, start + 64),
  farol_filled(tile, start + 96));
