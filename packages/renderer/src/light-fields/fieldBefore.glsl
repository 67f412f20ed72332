// For each row and cell, the number of the cell's lights in earlier rows; in the last row, in all rows.
// Knuth 1998, The Art of Computer Programming 3, 5.2: sorting by counting
uniform highp sampler2D farol_fieldCounts;
layout(location = 0) out highp vec4 farol_fieldBefore;
//# main
ivec2 at = ivec2(gl_FragCoord.xy);
float before = 0.0;
for (int row = 0; row < at.y; row++) before += texelFetch(farol_fieldCounts, ivec2(at.x, row), 0).r;
farol_fieldBefore = vec4(before);
