// Writes a finished picture and its depth to the host's target.
// Farol
#include "displayTransfer"
#include "viewport"
uniform highp sampler2D farol_picture;
uniform highp sampler2D farol_pictureDepth;
uniform bool farol_encode;
layout(location = 0) out highp vec4 farol_color;
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy - farol_offset);
farol_color = texelFetch(farol_picture, pixel, 0);
if (farol_encode) farol_color = farol_toDisplay(farol_color);
gl_FragDepth = texelFetch(farol_pictureDepth, pixel, 0).r;
