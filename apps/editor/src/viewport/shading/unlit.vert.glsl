// Computes position and texture coordinates, with bones, morph targets and instances.
#include <common>
#include <color_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
uniform mat3 mapTransform;
varying vec2 vMapUv;

void main() {
  vMapUv = (mapTransform * vec3(uv, 1.0)).xy;
  #include <color_vertex>
  #include <morphinstance_vertex>
  #include <skinbase_vertex>
  #include <begin_vertex>
  #include <morphtarget_vertex>
  #include <skinning_vertex>
  #include <project_vertex>
  #include <logdepthbuf_vertex>
}
