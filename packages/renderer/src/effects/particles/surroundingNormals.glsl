// Places a quad over each texel of a row, by gl_VertexID, and sets the texel's world-space normal.
int farol_texelIndex = gl_VertexID / 6;
int farol_texelCorner = gl_VertexID % 6;
bool farol_isRightCorner = farol_texelCorner == 1 || farol_texelCorner == 2 || farol_texelCorner == 4;
bool farol_isUpperCorner = farol_texelCorner == 2 || farol_texelCorner > 3;
farol_axisNormal = vec3(0.0);
if (farol_texelIndex < 6) {
  farol_axisNormal[farol_texelIndex >> 1] = (farol_texelIndex & 1) == 1 ? -1.0 : 1.0;
} else {
  farol_axisNormal = vec3(0.70710678);
  farol_axisNormal[farol_texelIndex - 6] = 0.0;
}
