// Light loop over the list of the pixel's tile, after the lights that reach everything.
// Olsson and Assarsson 2011, Tiled Shading; the bit lists after Drobot 2017, Improved Culling for Tiled and Clustered Rendering
#include "incidentLight"
#include "lightTiles"
#include "viewport"
uniform highp usampler2D farol_tileMask;
uniform highp usampler2D farol_tileSummary;

struct FarolListWalk {
  int next; // of the lights that reach everything
  int list;
  int page; // summary texel
  int word; // of the summary
  int part; // word of the quad
  int quad;
  uint quads; // bits of the summary word left
  uint bits; // of the quad's word left
  uvec4 summary;
  uvec4 mask;
};

FarolListWalk farol_beginWalk(const in vec2 fragCoord) {
  FarolListWalk walk;
  ivec2 tile = ivec2(fragCoord - farol_offset) >> farol_tiles.x;
  walk.next = 0;
  walk.list = tile.y * farol_tiles.y + tile.x;
  walk.page = 0;
  walk.word = 0;
  walk.part = 3;
  walk.quad = 0;
  walk.bits = 0u;
  walk.mask = uvec4(0u);
  walk.summary = farol_tileRun.y > 0 ? texelFetch(farol_tileSummary, farol_listTexel(walk.list * farol_tileRun.z), 0) : uvec4(0u);
  walk.quads = walk.summary.x;
  return walk;
}

// the next record, -1 after the last
int farol_nextLight(inout FarolListWalk walk) {
  if (walk.next < farol_tileRun.x) return walk.next++;
  while (walk.bits == 0u) {
    if (walk.part < 3) {
      walk.part++;
      walk.bits = walk.part == 1 ? walk.mask.y : walk.part == 2 ? walk.mask.z : walk.mask.w;
    } else {
      while (walk.quads == 0u) {
        if (walk.word == 3) {
          walk.page++;
          if (walk.page >= farol_tileRun.z) return -1;
          walk.summary = texelFetch(farol_tileSummary, farol_listTexel(walk.list * farol_tileRun.z + walk.page), 0);
          walk.word = 0;
        } else walk.word++;
        walk.quads = walk.word == 0 ? walk.summary.x : walk.word == 1 ? walk.summary.y : walk.word == 2 ? walk.summary.z : walk.summary.w;
      }
      walk.quad = walk.page * 128 + walk.word * 32 + farol_lowestBit(walk.quads);
      walk.quads &= walk.quads - 1u;
      walk.mask = texelFetch(farol_tileMask, farol_listTexel(walk.list * farol_tiles.w + walk.quad), 0);
      walk.part = 0;
      walk.bits = walk.mask.x;
    }
  }
  int bit = farol_lowestBit(walk.bits);
  walk.bits &= walk.bits - 1u;
  return farol_tileRun.x + walk.quad * 128 + walk.part * 32 + bit;
}

FarolLight farol_lightOf(const in int record, const in vec3 positionVS) {
  if (record < farol_lightCounts.x) return farol_directionalLight(record);
  return farol_localLight(record, positionVS);
}
#define FAROL_FOR_EACH_LIGHT(positionVS) \
  FarolListWalk farol_walk = farol_beginWalk(gl_FragCoord.xy); \
  for (int farol_record = farol_nextLight(farol_walk); farol_record >= 0; farol_record = farol_nextLight(farol_walk)) { \
    FarolLight farol_light = farol_lightOf(farol_record, positionVS); FAROL_SHADE(farol_light) }
