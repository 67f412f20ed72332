// Corners of many objects' triangles: each by the matrix of its object.
// Farol
layout(std140) uniform FarolCasters { vec4 farol_casterRows[FAROL_CASTERS * 3]; }; // rows of matrices
uniform mat4 modelViewMatrix; // from the origin that they count from
uniform mat4 projectionMatrix;
in vec4 position; // own space of its object (m), and which object
//# main
int farol_row = int(position.w) * 3;
vec4 farol_corner = vec4(position.xyz, 1.0);
vec3 farol_placed = vec3(dot(farol_casterRows[farol_row], farol_corner), dot(farol_casterRows[farol_row + 1], farol_corner), dot(farol_casterRows[farol_row + 2], farol_corner));
gl_Position = projectionMatrix * (modelViewMatrix * vec4(farol_placed, 1.0));
