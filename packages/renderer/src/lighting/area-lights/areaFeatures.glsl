// Kinds of area lights that shaders have code for: here all; renderers replace this chunk by the kinds used so far.
// Farol
#define FAROL_AREA_KINDS 31 // bits: 1 rectangles, 2 discs, 4 tubes; 8 with a range, 16 without
