// Distances (m) of the nearest (negative if its surface moves) and the farthest of a pixel's 3 × 3 samples.
// Karis 2014, High Quality Temporal Supersampling (dilation)
#include "taaDepth"
layout(location = 0) out highp vec2 farol_reach;
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy);
ivec2 nearest = pixel;
farol_reach = vec2(6e4, 0.0);
for (int y = -1; y <= 1; y++) for (int x = -1; x <= 1; x++) {
  ivec2 at = farol_inPicture(pixel + ivec2(x, y));
  float there = farol_distanceAt(at);
  if (there < farol_reach.x) { farol_reach.x = there; nearest = at; }
  farol_reach.y = max(farol_reach.y, there);
}
if (farol_hasMotion && texelFetch(farol_motionMap, nearest, 0).w > 0.5) farol_reach.x = -farol_reach.x;
