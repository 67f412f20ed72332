// Rounds to the nearest half float: drivers may cut what is written to a target of half floats, which darkens sums.
// IEEE 754 binary16 (10 bits of the fraction's 23); OpenGL ES 3.0, 2.1.3 leaves the rounding to the driver
//? farol_roundToHalf(vec3(0.3333)) == vec3(0.33325195)
vec3 farol_roundToHalf(const in vec3 value) {
  return uintBitsToFloat((floatBitsToUint(value) + 0x1000u) & 0xFFFFE000u);
}
