// One pixel of the G-buffer: a texel for each attachment, and one for depth.
// Thesis 2.2.3.1
#include "gbufferTextures"
uniform highp ivec2 thesis_pixel;
layout(location = 0) out highp vec4 thesis_value;
//# main
int row = int(gl_FragCoord.x);
if (row == 0) thesis_value = vec4(farol_gDepthAt(thesis_pixel));
else if (row == 1) thesis_value = farol_gAccumulationAt(thesis_pixel);
else if (row == 2) thesis_value = farol_gNormalAt(thesis_pixel);
else if (row == 3) thesis_value = farol_gMaterialAt(thesis_pixel);
else thesis_value = farol_gAlbedoAt(thesis_pixel);
