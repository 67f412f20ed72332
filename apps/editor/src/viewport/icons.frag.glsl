// Draws an icon: the red channel of the atlas is its stroke, green its disc.
uniform sampler2D atlas;
uniform float count;
varying vec3 vTint;
varying float vKind;
varying float vSelected;

void main() {
  vec2 uv = vec2((vKind + gl_PointCoord.x) / count, 1.0 - gl_PointCoord.y);
  vec2 mask = texture2D(atlas, uv).rg;
  if (mask.g < 0.02) discard;
  vec3 disc = mix(vec3(0.012), vec3(0.9, 0.32, 0.03), vSelected);
  vec3 stroke = mix(vTint, vec3(1.0), vSelected);
  gl_FragColor = vec4(mix(disc, stroke, mask.r), mask.g * mix(0.72, 1.0, max(mask.r, vSelected)));
  #include <colorspace_fragment>
}
