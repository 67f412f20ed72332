// Writes both eyes' layers of an array, with depth, side by side.
// Farol
#include "viewport"
uniform highp sampler2DArray farol_eyes;
uniform highp sampler2DArray farol_eyeDepths;
uniform highp int farol_eyeWidth; // width of one eye's picture (pixels)
layout(location = 0) out highp vec4 farol_color;
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy - farol_offset);
ivec3 texel = ivec3(pixel.x % farol_eyeWidth, pixel.y, pixel.x / farol_eyeWidth);
farol_color = texelFetch(farol_eyes, texel, 0);
gl_FragDepth = texelFetch(farol_eyeDepths, texel, 0).r;
