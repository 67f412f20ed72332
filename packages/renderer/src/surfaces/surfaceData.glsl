// Arguments of the hooks of a surface: displace() takes a vertex, surface() a pixel.
// docs/surfaces.md
struct VertexData {
  vec3 positionOS; // m, local space, morphed, before skinning; may be changed
  vec3 normalOS; // local space; may be changed
  vec2 uv;
  float time; // s
};
struct SurfaceData {
  vec3 positionOS; // m, position in the geometry, neither displaced nor morphed, so that patterns stick to it
  vec3 positionWS; // m
  vec3 positionVS; // m
  vec3 normalOS; // normal of the geometry, not of unit length
  vec3 normalWS; // world-space normal before the first surface
  vec3 normalVS; // unit length, on the viewer's side, normal map included; may be changed
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
