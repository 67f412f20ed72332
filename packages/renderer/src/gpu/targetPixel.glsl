// Position of a pixel in the host's target, also while the bound target begins at the viewport's first pixel.
// Farol
uniform highp vec2 farol_targetOrigin; // pixel of the host's target for the first pixel of the bound target
#ifndef FAROL_PER_VERTEX
vec2 farol_targetPixel() { return gl_FragCoord.xy + farol_targetOrigin; }
#endif
