// Size of the picture (pixels), which is the used part of Farol's targets; these may be larger.
// Farol
uniform highp vec2 farol_frameSize;
