// Light loop over the list of the pixel's tile, after the lights that reach everything.
// Olsson and Assarsson 2011, Tiled Shading; the bit lists after Drobot 2017, Improved Culling for Tiled and Clustered Rendering
#include "incidentLight"
#include "lightList"

#define FAROL_LISTED_BITS(bits, start, positionVS) bits
