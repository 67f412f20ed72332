// Sort keys of particles: the distance of each along the view, in last frame's order.
// Farol
uniform highp sampler2D farol_particlePositions; // by slot; xyz: world space (m); w: age (s)
uniform highp sampler2D farol_particleVelocities; // by slot; xyz: m/s; w: life (s)
uniform highp sampler2D farol_sorted; // last frame's order: distance along the view (m), slot
uniform highp vec4 farol_viewRow; // third row of the view matrix, gives view-space z
uniform highp ivec3 farol_sortSlots; // x: slots; y: columns of the texture; z: 1 to begin with the order of slots
layout(location = 0) out highp vec2 farol_key;
//# main
ivec2 texel = ivec2(gl_FragCoord.xy);
int slot = texel.y * farol_sortSlots.y + texel.x;
if (farol_sortSlots.z == 0) slot = int(texelFetch(farol_sorted, texel, 0).y);
int columns = textureSize(farol_particlePositions, 0).x;
ivec2 at = ivec2(slot % columns, slot / columns);
// slots without a particle come last
farol_key = vec2(-1e30, slot);
if (slot < farol_sortSlots.x) {
  vec4 center = texelFetch(farol_particlePositions, at, 0);
  if (center.w < texelFetch(farol_particleVelocities, at, 0).w) {
    farol_key.x = -dot(farol_viewRow, vec4(center.xyz, 1.0));
  }
}
