// Writes 1, so that blending counts the draws of a pixel.
// Farol
layout(location = 0) out highp vec4 farol_one;
//# main
farol_one = vec4(1.0);
