// Corners of many objects' triangles: each by the matrix of its object.
// Farol
layout(std140) uniform FarolCasters { vec4 farol_casterRows[FAROL_CASTERS * 3]; }; // rows of matrices
uniform mat4 farol_casterView; // to clip space, from where they count from
in vec4 position; // own space of its object (m), and which object
//# main
int farol_row = int(position.w) * 3;
vec4 farol_corner = vec4(position.xyz, 1.0);
gl_Position = farol_casterView * vec4(dot(farol_casterRows[farol_row], farol_corner),
  dot(farol_casterRows[farol_row + 1], farol_corner), dot(farol_casterRows[farol_row + 2], farol_corner), 1.0);
