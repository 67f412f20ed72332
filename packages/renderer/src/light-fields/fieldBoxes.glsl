// Bounding box (view space) of each 32 lights' ranges: a texel for 32 lights, four for a quad of 128.
// Farol
#include "lightTable"
#include "lightTiles"
layout(location = 0) out highp vec4 farol_boxLow; // xyz: low corner (m), w: z of the high corner
layout(location = 1) out highp vec4 farol_boxHigh; // xyz: high corner (m)
//# main
int start = int(gl_FragCoord.y) * 128 + int(gl_FragCoord.x) * 32;
int end = min(start + 32, farol_tileRun.y);
vec3 low = vec3(1e30);
vec3 high = vec3(-1e30);
for (int light = start; light < end; light++) {
  vec4 sphere = farol_lightSphere(farol_tileRun.x + light);
  // skips lights without effect, which fieldLight.glsl places at x = 1e15 m
  if (sphere.x < 1e14) {
    // widened by rounding errors, as in the tests of single lights
    low = min(low, sphere.xyz - sphere.w * 1.001);
    high = max(high, sphere.xyz + sphere.w * 1.001);
  }
}
farol_boxLow = vec4(low, high.z);
farol_boxHigh = vec4(high, 0.0);
