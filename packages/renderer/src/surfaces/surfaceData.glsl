// What the hooks of a surface are given: displace() a vertex, surface() a pixel.
// docs/surfaces.md
struct VertexData {
  vec3 positionOS; // m, in the object's own space, morphed and before its bones; to be changed
  vec3 normalOS; // to be changed
  vec2 uv;
  float time; // s
};
struct SurfaceData {
  vec3 positionOS; // m, of the geometry: neither displaced nor morphed, so that patterns stick to it
  vec3 positionWS; // m
  vec3 positionVS; // m
  vec3 normalOS; // of the mesh, not of unit length
  vec3 normalWS; // as it was before the first surface
  vec3 normalVS; // unit length, towards the viewer's side, normal map included; to be changed
  vec3 viewDirectionVS; // unit length, towards the camera
  vec2 uv;
  float time; // s
  bool frontFacing;
  // to be changed
  vec3 color; // linear
  float opacity;
  float roughness;
  float metalness;
  vec3 emissive; // linear
};
