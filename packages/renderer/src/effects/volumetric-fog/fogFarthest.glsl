// A triangle that covers the viewport at the far end of depth, reversed or not.
// Bilodeau, Vertex Shader Tricks, GDC 2014
uniform highp float farol_farthest; // clip-space z of the farthest depth
//# main
gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, farol_farthest, 1.0);
