// Shows the base colour and emission of a surface, unlit.
#include <common>
#include <color_pars_fragment>
#include <logdepthbuf_pars_fragment>
uniform vec3 colour;
uniform vec3 emitted;
uniform float opacity;
uniform float alphaTest;
uniform bool hasMap;
uniform sampler2D map;
varying vec2 vMapUv;

void main() {
  #include <logdepthbuf_fragment>
  vec4 diffuseColor = vec4(colour, opacity);
  if (hasMap) diffuseColor *= texture2D(map, vMapUv);
  #include <color_fragment>
  // nearly transparent pixels are discarded
  if (diffuseColor.a < max(alphaTest, 0.1)) discard;
  gl_FragColor = vec4(diffuseColor.rgb + emitted, 1.0);
  #include <colorspace_fragment>
}
