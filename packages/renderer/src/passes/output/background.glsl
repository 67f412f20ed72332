// The colour behind everything, as the target would have been cleared to it.
// Farol
uniform vec4 farol_background;
layout(location = 0) out highp vec4 farol_color;
//# main
farol_color = farol_background;
