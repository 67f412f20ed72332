// Sorts lights by cells: draws a point for each light at its sorted index, with the light's number as colour.
// Knuth 1998, The Art of Computer Programming 3, 5.2: sorting by counting
uniform highp sampler2D farol_fieldCells;
uniform highp sampler2D farol_fieldBefores;
uniform highp sampler2D farol_fieldFirsts;
uniform highp int farol_fieldRows;
flat out highp float farol_fieldLight;
//# main
ivec2 light = ivec2(gl_VertexID & 127, gl_VertexID >> 7);
float cell = texelFetch(farol_fieldCells, light, 0).r;
float place = texelFetch(farol_fieldFirsts, ivec2(int(cell), 0), 0).r
  + texelFetch(farol_fieldBefores, ivec2(int(cell), light.y), 0).r;
for (int x = 0; x < light.x; x++) {
  if (texelFetch(farol_fieldCells, ivec2(x, light.y), 0).r == cell) place += 1.0;
}
ivec2 at = ivec2(int(place) & 127, int(place) >> 7);
farol_fieldLight = float(gl_VertexID);
gl_Position = vec4((vec2(at) + 0.5) / vec2(128.0, float(farol_fieldRows)) * 2.0 - 1.0, 0.0, 1.0);
gl_PointSize = 1.0;
