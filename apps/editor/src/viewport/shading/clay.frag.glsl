// Shades in grey, lit from the eye and from the upper left, so that shapes are visible without the scene's lights.
#include <common>
#include <logdepthbuf_pars_fragment>
varying vec3 vNormalVS;
varying vec3 vPositionVS;

void main() {
  #include <logdepthbuf_fragment>
  vec3 normal = normalize(vNormalVS);
  if (dot(normal, normal) < 0.5 || any(isnan(normal))) normal = normalize(cross(dFdx(vPositionVS), dFdy(vPositionVS)));
  normal *= gl_FrontFacing ? 1.0 : -1.0;
  float fromLeft = max(dot(normal, normalize(vec3(-0.5, 0.7, 0.6))), 0.0);
  float light = 0.16 + 0.34 * max(normal.z, 0.0) + 0.32 * fromLeft;
  gl_FragColor = vec4(vec3(0.62, 0.6, 0.57) * light, 1.0);
  #include <colorspace_fragment>
}
