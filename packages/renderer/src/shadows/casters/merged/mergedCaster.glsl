// Corners of many casters' triangles, each moved by the matrix of its caster.
// Farol
layout(std140) uniform FarolCasters { vec4 farol_casterRows[FAROL_CASTERS * 3]; }; // three rows of each world matrix
uniform mat4 farol_clipFromOrigin; // transform to clip space from world axes with the origin of the casters' matrices
in vec4 position; // xyz: position in the caster's local space (m); w: the caster's index
//# main
int farol_row = int(position.w) * 3;
vec4 farol_corner = vec4(position.xyz, 1.0);
vec3 farol_moved = vec3(dot(farol_casterRows[farol_row], farol_corner),
  dot(farol_casterRows[farol_row + 1], farol_corner),
  dot(farol_casterRows[farol_row + 2], farol_corner));
gl_Position = farol_clipFromOrigin * vec4(farol_moved, 1.0);
