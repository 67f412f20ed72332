// Rounds to the nearest half float: some drivers truncate values written to half-float targets, with twice the error.
// IEEE 754 binary16 (10 bits of the fraction's 23); OpenGL ES 3.0, 2.1.3 leaves the rounding to the driver
//? farol_roundToHalf(vec2(0.3333, -0.3333)) == vec2(0.33325195, -0.33325195)
//? farol_roundToHalf(vec2(1.0, 0.0)) == vec2(1.0, 0.0)
vec2 farol_roundToHalf(const in vec2 value) {
  vec2 rounded = uintBitsToFloat((floatBitsToUint(value) + 0x1000u) & 0xFFFFE000u);
  return all(lessThanEqual(abs(value), vec2(65504.0))) ? rounded : value; // beyond half floats: unchanged
}
