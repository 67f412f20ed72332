// Pixel of the G-buffer that is being shaded, for functions that read its neighbours.
// Farol
ivec2 farol_readPixel = ivec2(0);
vec2 farol_readSize = vec2(0.0); // size of the picture (pixels); 0 in shaders that read no G-buffer
// position of the surface in a pixel (view space, m); redefined by chunks that read a G-buffer
#define FAROL_POSITION_AT(pixel) vec3(0.0)
