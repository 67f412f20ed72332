// Light loop over the list of the pixel's tile, after the lights that reach everything.
// Olsson and Assarsson 2011, Tiled Shading
#include "shadePlain"
#include "lightList"
