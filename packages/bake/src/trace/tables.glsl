// Reads tables of float quadruples, 2,048 texels per row
// three.js, DataTexture
vec4 farol_table(const in highp sampler2D table, const in int index) {
  return texelFetch(table, ivec2(index & 2047, index >> 11), 0);
}
