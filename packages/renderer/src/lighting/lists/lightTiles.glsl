// Where the light lists of the screen's tiles lie, and single bits of them.
// Farol; a list is a bit a light, 128 lights a texel (a quad of words), lists one after another in rows of 2,048 texels
//? farol_lowestBit(1u) == 0
//? farol_lowestBit(2147483648u) == 31
//? farol_lowestBit(40u) == 3
//? farol_bitsFrom(0, 0, 31) == 4294967295u
//? farol_bitsFrom(32, 33, 34) == 6u
//? farol_bitsFrom(32, 0, 20) == 0u
uniform highp ivec4 farol_tiles; // pixels a side, as a power of two; tiles in x; tiles in y; quads a tile
// first record of the listed lights; their number; summary texels a tile; quads of plain point lights
uniform highp ivec4 farol_tileRun;

ivec2 farol_listTexel(const in int index) {
  return ivec2(index & 2047, index >> 11);
}

int farol_lowestBit(const in uint bits) {
  return (floatBitsToInt(float(bits & (~bits + 1u))) >> 23) - 127;
}

// of a word that stands for lights start to start + 31: the bits of lights first to last
uint farol_bitsFrom(const in int start, const in int first, const in int last) {
  int low = max(first - start, 0);
  int high = min(last - start, 31);
  if (low > high) return 0u;
  return (4294967295u << uint(low)) & (4294967295u >> uint(31 - high));
}
