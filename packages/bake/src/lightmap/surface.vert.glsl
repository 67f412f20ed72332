// Draws surfaces at their lightmap UVs
// three.js
in vec3 position;
in vec3 normal;
in vec3 face;
in vec2 lightmapUV;
in vec2 mapUV;
in vec2 emissiveUV;
in vec3 colour;
uniform vec2 farol_shift; // offset (lightmap UV) of this draw, of up to a texel: see SHIFTS in Surfaces.ts
out vec3 farol_position;
out vec3 farol_normal;
flat out vec3 farol_face;
out vec2 farol_mapUV;
out vec2 farol_emissiveUV;
out vec3 farol_colour;

void main() {
  farol_position = position;
  farol_normal = normal;
  farol_face = face;
  farol_mapUV = mapUV;
  farol_emissiveUV = emissiveUV;
  farol_colour = colour;
  gl_Position = vec4(2.0 * (lightmapUV + farol_shift) - 1.0, 0.0, 1.0);
}
