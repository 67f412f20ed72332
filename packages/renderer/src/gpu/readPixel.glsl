// The pixel of a G-buffer that is lit, for what goes by the pixels beside it.
// Farol
ivec2 farol_readPixel = ivec2(0);
vec2 farol_readSize = vec2(0.0); // of the picture (pixels); 0 in shaders that read no G-buffer
// position of the surface in a pixel (view space, m); chunks that read a G-buffer define it anew
#define FAROL_POSITION_AT(pixel) vec3(0.0)
