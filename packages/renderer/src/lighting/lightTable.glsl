// The light table: one record of four RGBA32F texels a light, read by index.
// Farol; layout in lights/lightRecord.ts
uniform highp sampler2D farol_lightTable;
// x: directional lights, y: local lights without a range, z: local lights with a range, w: of the last, those that are
// no plain point lights
uniform highp ivec4 farol_lightCounts;

vec4 farol_lightTexel(const in int record, const in int texel) {
  return texelFetch(farol_lightTable, ivec2((record & 255) * 4 + texel, record >> 8), 0);
}
