// Nothing is rasterised.
// OpenGL ES 3.0 specification, 3.1
void main() {}
