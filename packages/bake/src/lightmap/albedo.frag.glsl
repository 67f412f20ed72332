// Diffuse albedo of a surface, or its emitted radiance
// three.js, lights_physical_fragment
in vec2 farol_mapUV;
in vec2 farol_emissiveUV;
in vec3 farol_colour;
uniform vec3 farol_factor;
uniform sampler2D farol_map;
uniform sampler2D farol_metalnessMap;
uniform float farol_metalness;
uniform bvec3 farol_uses; // which inputs the material has: map, metalness map, vertex colours
layout(location = 0) out highp vec4 farol_out;

void main() {
  vec3 colour = farol_factor;
#ifdef EMISSION
  if (farol_uses.x) colour *= texture(farol_map, farol_emissiveUV).rgb;
#else
  if (farol_uses.x) colour *= texture(farol_map, farol_mapUV).rgb;
  if (farol_uses.z) colour *= farol_colour;
  float metalness = farol_metalness;
  if (farol_uses.y) metalness *= texture(farol_metalnessMap, farol_mapUV).b;
  colour *= 1.0 - metalness;
#endif
  farol_out = vec4(colour, 1.0);
}
