// Texels of the light lists of the screen's tiles, and functions on their bits.
// Farol; a list has one bit for each light, 128 lights a texel (a quad of words). The texels of one quad form a grid
// like the screen's tiles, so that neighbours test similar lights; the grids of all quads lie side by side.
//? farol_lowestBit(1u) == 0
//? farol_lowestBit(2147483648u) == 31
//? farol_lowestBit(40u) == 3
//? farol_bitsFrom(0, 0, 31) == 4294967295u
//? farol_bitsFrom(32, 33, 34) == 6u
//? farol_bitsFrom(32, 0, 20) == 0u
//? farol_packGap(vec2(0.0, 1.0)) == 4294770692u
//? farol_packGap(vec2(1.0, 0.0)) == 65534u
// x: log2 of the number of grids in a row of a list texture; y, z: tiles in x and y; w: quads in each tile's list
uniform highp ivec4 farol_tiles;
// x: first record of the listed lights; y: their number; z: summary texels a tile; w: quads of plain point lights
uniform highp ivec4 farol_tileRun;

const int FAROL_TILE_SHIFT = 4; // log2 of a tile's side (pixels)

// texel of a tile, or block of tiles, in grid number index of a list texture; grid: size of one grid
ivec2 farol_listTexel(const in ivec2 tile, const in ivec2 grid, const in int index) {
  return tile + grid * ivec2(index & ((1 << farol_tiles.x) - 1), index >> farol_tiles.x);
}

int farol_lowestBit(const in uint bits) {
  return (floatBitsToInt(float(bits & (~bits + 1u))) >> 23) - 127;
}

// mask of the bits of lights first to last in a word whose 32 bits stand for lights start to start + 31
uint farol_bitsFrom(const in int start, const in int first, const in int last) {
  int low = max(first - start, 0);
  int high = min(last - start, 31);
  if (low > high) return 0u;
  return (4294967295u << uint(low)) & (4294967295u >> uint(31 - high));
}

// packs a tile's largest gap between surfaces (start, end, 0 to 1 within its depth range), made smaller by rounding;
// bit 0 is left free
uint farol_packGap(const in vec2 gap) {
  vec2 steps = clamp(gap, 0.0, 1.0) * vec2(32767.0, 65535.0) + vec2(2.0, -2.0);
  return min(uint(steps.x), 32767u) << 1 | uint(max(steps.y, 0.0)) << 16;
}

vec2 farol_unpackGap(const in uint packed) {
  return vec2(packed >> 1 & 32767u, packed >> 16) / vec2(32767.0, 65535.0);
}
