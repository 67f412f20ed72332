// Draws the background's colour, also at pixels whose middle a surface covers.
// Chajdas, McGuire and Luebke 2011, Subpixel Reconstruction Antialiasing
#include "edgeColor"
uniform highp float farol_farthest; // depth-buffer value of the far plane
layout(location = 0) out highp vec4 farol_color;
//# main
float shown;
farol_edgeColor(ivec2(gl_FragCoord.xy), farol_farthest, vec2(0.0), 0.0, true, farol_color, shown);
farol_color.a += shown;
