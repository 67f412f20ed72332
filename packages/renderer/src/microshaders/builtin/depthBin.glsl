// Bin of a depth (m, -z in view space), as lights/DepthBins.ts cuts them: from the bits of a float, which grow as its logarithm.
// Farol; bins after Drobot 2017, Improved Culling for Tiled and Clustered Rendering in Call of Duty: Infinite Warfare
//? farol_depthBin(1.0, 0.0, 1065287422, 1020.0 / 33554432.0) == 2
//? farol_depthBin(16.0, 0.0, 1065287422, 1020.0 / 33554432.0) == 1022
//? farol_depthBin(4.0, 0.0, 1065287422, 1020.0 / 33554432.0) == 512
//? farol_depthBin(0.1, 0.0, 1065287422, 1020.0 / 33554432.0) == 0
//? farol_depthBin(1e30, 0.0, 1065287422, 1020.0 / 33554432.0) == 1023
//? farol_depthBin(-100.0, 5.0, 1065287422, 1020.0 / 33554432.0) == 0
int farol_depthBin(const in float depth, const in float shift, const in int start, const in float scale) {
  return clamp(int(float(floatBitsToInt(max(depth + shift, 0.0)) - start) * scale), 0, 1023);
}
