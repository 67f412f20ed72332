// Counts the lights of each cell in each row of 128 lights: draws a point for each light, blended additively.
// Knuth 1998, The Art of Computer Programming 3, 5.2: sorting by counting
uniform highp sampler2D farol_fieldCells;
uniform highp vec2 farol_fieldCountSize;
//# main
ivec2 light = ivec2(gl_VertexID & 127, gl_VertexID >> 7);
float cell = texelFetch(farol_fieldCells, light, 0).r;
gl_Position = vec4(vec2(cell + 0.5, float(light.y) + 0.5) / farol_fieldCountSize * 2.0 - 1.0, 0.0, 1.0);
gl_PointSize = 1.0;
