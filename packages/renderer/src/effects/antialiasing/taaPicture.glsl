// Averages the history's cells of each pixel, by one bilinear read between them.
// Yang et al. 2009, Amortized Supersampling
uniform highp sampler2D farol_history; // accumulated colours of the last frame, filtered linearly
uniform int farol_cells; // history cells along a pixel's side: 1 or 2
layout(location = 0) out highp vec4 farol_color;
//# main
farol_color = texture(farol_history, gl_FragCoord.xy * float(farol_cells) / vec2(textureSize(farol_history, 0)));
