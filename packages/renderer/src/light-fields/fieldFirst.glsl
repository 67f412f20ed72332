// Index of the first light of each cell in the sorted order.
// Knuth 1998, The Art of Computer Programming 3, 5.2: sorting by counting
uniform highp sampler2D farol_fieldBefores;
uniform highp int farol_fieldRows;
layout(location = 0) out highp vec4 farol_fieldFirst;
//# main
float first = 0.0;
for (int cell = 0; cell < int(gl_FragCoord.x); cell++)
  first += texelFetch(farol_fieldBefores, ivec2(cell, farol_fieldRows), 0).r;
farol_fieldFirst = vec4(first);
