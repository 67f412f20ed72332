// Size of the picture (pixels): the used part of Farol's targets, which may be larger.
// Farol
uniform highp vec2 farol_frameSize;
