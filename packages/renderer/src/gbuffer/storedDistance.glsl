// A surface's distance (its logarithm in perspective) in two half floats, accurate to some millionths.
// Farol
#include "roundToHalf"
//? farol_unpackDistance(farol_packDistance(1234.5, false), false) == 1234.5
//? farol_unpackDistance(farol_packDistance(0.00003, false), false) * 100000.0 == 3.0
//? farol_unpackDistance(farol_packDistance(-123.4, true), true) == -123.4
vec2 farol_packDistance(const in float distanceVS, const in bool orthographic) {
  if (orthographic) {
    // not packHalf2x16: a driver may optimise packing and unpacking away, and with it the rounding
    float high = farol_roundToHalf(vec2(distanceVS)).x;
    return farol_roundToHalf(vec2(high, distanceVS - high));
  }
  float logarithm = log2(max(distanceVS, 1e-9));
  float high = floor(logarithm * 32.0 + 0.5) / 32.0;
  return farol_roundToHalf(vec2(high, logarithm - high));
}

float farol_unpackDistance(const in vec2 stored, const in bool orthographic) {
  return orthographic ? stored.x + stored.y : exp2(stored.x + stored.y);
}
