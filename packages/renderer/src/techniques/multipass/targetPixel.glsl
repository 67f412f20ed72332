// Place of a pixel in the host's target, while light is summed in a target that begins at the viewport's first pixel.
// Farol
#include "viewport"
vec2 farol_targetPixel() { return gl_FragCoord.xy + farol_offset; }
