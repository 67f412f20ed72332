// Writes 1, so that blending counts what is drawn.
// Farol
layout(location = 0) out highp vec4 farol_one;
//# main
farol_one = vec4(1.0);
