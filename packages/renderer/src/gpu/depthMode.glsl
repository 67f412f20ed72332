// Storage of depth (growing with distance, reversed, or logarithmic), and a test for empty pixels.
// Farol; three.js's WebGLRenderer options reversedDepthBuffer and logarithmicDepthBuffer
uniform highp vec2 farol_depthMode; // x: 1 if depth is reversed, else 0; y: log2(far + 1) if logarithmic, else 0

bool farol_isEmpty(const in float depth) {
  return farol_depthMode.x > 0.0 ? depth <= 0.0 : depth >= 1.0;
}
