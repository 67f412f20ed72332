// Averages ambient occlusion over 4 × 4 texels on the pixel's own surface, at full resolution.
// Kopf et al. 2007, Joint Bilateral Upsampling; Jimenez et al. 2016 (GTAO), spatial filter
#include "occlusionSurface"
uniform highp sampler2D farol_openMap;
uniform highp vec4 farol_reach; // x: radius (m); y: radius at 1 m (pixels); w: its maximum (pixels); z: pixels a texel
uniform highp float farol_strength; // strength of the occlusion: exponent of the share of the sky that is open
#ifdef FAROL_ACCUMULATION
uniform highp sampler2D farol_lit; // sum of emissive and indirect light
uniform highp sampler2D farol_indirect; // indirect light alone
#endif
layout(location = 0) out highp vec4 farol_result;
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy);
float depth = texelFetch(farol_surfaceDepth, pixel, 0).r;
float open = 1.0;
if (!farol_isEmpty(depth)) {
  float z = farol_surfaceZ(pixel);
  // change of view z to the next pixel in x and y: the smaller of the differences to the two sides
  vec2 zs0 = z - vec2(farol_surfaceZ(pixel - ivec2(1, 0)), farol_surfaceZ(pixel - ivec2(0, 1)));
  vec2 zs1 = vec2(farol_surfaceZ(pixel + ivec2(1, 0)), farol_surfaceZ(pixel + ivec2(0, 1))) - z;
  vec2 slope = vec2(abs(zs0.x) < abs(zs1.x) ? zs0.x : zs1.x, abs(zs0.y) < abs(zs1.y) ? zs0.y : zs1.y);
  float near = max(0.1 * farol_reach.x, 2.0 * max(abs(slope.x), abs(slope.y)));
  vec2 place = gl_FragCoord.xy / farol_reach.z;
  ivec2 base = ivec2(floor(place)) - 1;
  ivec2 last = ivec2(ceil(farol_frameSize / farol_reach.z)) - 1;
  float sum = 0.0;
  float total = 0.0;
  for (int y = 0; y < 4; y++) for (int x = 0; x < 4; x++) {
    ivec2 at = clamp(base + ivec2(x, y), ivec2(0), last);
    vec2 there = texelFetch(farol_openMap, at, 0).rg;
    vec2 off = vec2(at) * farol_reach.z - vec2(pixel);
    float distance = abs(there.g - (z + dot(slope, off)));
    float weight = max(1.0 - distance / near, 1e-4);
    if (there.g == 0.0) weight = 1e-6;
    sum += weight * there.r;
    total += weight;
  }
  open = pow(sum / total, farol_strength);
}
#ifdef FAROL_ACCUMULATION
// infinite radiance counts as the greatest half float
farol_result = min(texelFetch(farol_lit, pixel, 0), 65504.0);
farol_result.rgb = max(farol_result.rgb - (1.0 - open) * min(texelFetch(farol_indirect, pixel, 0).rgb, 65504.0), 0.0);
#else
farol_result = vec4(open);
#endif
