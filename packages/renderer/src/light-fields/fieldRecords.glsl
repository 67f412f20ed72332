// Writes the light table that shaders read: the CPU's records, and those of light fields inserted among them.
// Farol; layout in lights/lightRecord.ts
uniform highp sampler2D farol_hostTable;
uniform highp sampler2D farol_fieldSpheres;
uniform highp sampler2D farol_fieldEmissions;
uniform highp sampler2D farol_fieldCones;
uniform highp sampler2D farol_fieldOrder;
uniform highp ivec3 farol_fieldSlots; // x: first record of fields; y: their number; z: 1 to read in farol_fieldOrder
layout(location = 0) out highp vec4 farol_texel;
//# main
ivec2 at = ivec2(gl_FragCoord.xy);
int record = (at.y << 8) + (at.x >> 2);
int texel = at.x & 3;
int slot = record - farol_fieldSlots.x;
if (slot < 0 || slot >= farol_fieldSlots.y) {
  if (slot >= 0) record -= farol_fieldSlots.y;
  farol_texel = texelFetch(farol_hostTable, ivec2(((record & 255) << 2) + texel, record >> 8), 0);
} else {
  ivec2 light = ivec2(slot & 127, slot >> 7);
  if (farol_fieldSlots.z > 0) {
    int number = int(texelFetch(farol_fieldOrder, light, 0).r);
    light = ivec2(number & 127, number >> 7);
  }
  if (texel == 0) farol_texel = texelFetch(farol_fieldSpheres, light, 0);
  else if (texel == 1) farol_texel = texelFetch(farol_fieldEmissions, light, 0);
  else {
    vec4 cone = texelFetch(farol_fieldCones, light, 0);
    float size = max(length(cone.xyz), 1.0);
    farol_texel = texel == 2 ? vec4(cone.xyz / size, cone.w) : vec4(size - 2.0, -1.0, 0.0, 0.0);
  }
}
