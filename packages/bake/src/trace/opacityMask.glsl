// Draws the opacity of a material's maps over their whole UV square
// three.js, alphamap_fragment
uniform sampler2D map;
uniform sampler2D alphaMap;
uniform vec2 has;
layout(location = 0) out vec4 farol_opacity;

void main() {
  vec2 uv = gl_FragCoord.xy / 512.0;
  float opacity = has.x > 0.0 ? texture(map, uv).a : 1.0;
  if (has.y > 0.0) opacity *= texture(alphaMap, uv).g;
  farol_opacity = vec4(opacity);
}
