// Rectangles of the atlas of shadow maps at the far end of depth, instanced: two triangles each.
// Farol
uniform highp float farol_far; // 1, or 0 where depth is reversed
in vec4 farol_rectangle; // left, bottom, right, top (normalised device coordinates)
//# main
int corner = gl_VertexID > 2 ? gl_VertexID - 2 : gl_VertexID; // 0 1 2, 1 2 3
gl_Position = vec4((corner & 1) == 0 ? farol_rectangle.x : farol_rectangle.z, (corner & 2) == 0 ? farol_rectangle.y : farol_rectangle.w, farol_far, 1.0);
