// Place of a pixel in the host's target, also while a target is bound that begins at the viewport's first pixel.
// Farol
uniform highp vec2 farol_targetOrigin; // pixel of the host's target that the first pixel of the bound target stands for
#ifndef FAROL_PER_VERTEX
vec2 farol_targetPixel() { return gl_FragCoord.xy + farol_targetOrigin; }
#endif
