// Places the corners of many objects' triangles, each by the matrix of its object; kept by transform feedback.
// OpenGL ES 3.0 specification, 2.15
layout(std140) uniform FarolCasters { vec4 farol_casterRows[FAROL_CASTERS * 3]; }; // rows of matrices
in vec4 farol_corner; // own space of its object (m), and which object
out vec3 farol_placed; // m, from the origin that the matrices count from

void main() {
  int row = int(farol_corner.w) * 3;
  vec4 corner = vec4(farol_corner.xyz, 1.0);
  farol_placed = vec3(dot(farol_casterRows[row], corner), dot(farol_casterRows[row + 1], corner), dot(farol_casterRows[row + 2], corner));
  gl_Position = vec4(0.0);
}
