// The picture from a history of cells, the mean of those of each pixel.
// Yang et al. 2009, Amortized Supersampling
uniform highp sampler2D farol_history;
uniform int farol_cells; // along a pixel's side
layout(location = 0) out highp vec4 farol_color;
//# main
ivec2 first = ivec2(gl_FragCoord.xy) * farol_cells;
farol_color = vec4(0.0);
for (int y = 0; y < farol_cells; y++) for (int x = 0; x < farol_cells; x++) farol_color += texelFetch(farol_history, first + ivec2(x, y), 0);
farol_color /= float(farol_cells * farol_cells);
