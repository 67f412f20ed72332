// Arguments of the hooks of a surface: displace() takes a vertex, surface() a pixel.
// docs/surfaces.md
struct VertexData {
  vec3 positionOS; // position of the vertex (m): local space, morphed, before skinning; surfaces may change it
  vec3 normalOS; // normal of the vertex, local space; surfaces may change it
  vec2 uv;
  float time; // time (s)
};
struct SurfaceData {
  vec3 positionOS; // position in the geometry (m), before displacement and morphs, so that patterns stick to it
  vec3 positionWS; // position of the pixel's surface, world space (m)
  vec3 positionVS; // position of the pixel's surface, view space (m)
  vec3 normalOS; // normal of the geometry, not of unit length
  vec3 normalWS; // world-space normal before the first surface
  vec3 normalVS; // view-space normal, unit length, on the viewer's side, normal map included; may be changed
  vec3 viewDirectionVS; // direction to the camera, view space, unit length
  vec2 uv;
  float time; // time (s)
  bool frontFacing;
  // members below: a surface may change them
  vec3 color; // linear colour
  float opacity;
  float roughness;
  float metalness;
  vec3 emissive; // emitted light, linear RGB
};
