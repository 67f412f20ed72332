// Size of the picture (pixels): the part of Farol's targets that is drawn to, which may be larger.
// Farol
uniform highp vec2 farol_frameSize;
