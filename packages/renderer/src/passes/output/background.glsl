// Clear colour of the target, for passes that write every pixel.
// Farol
uniform vec4 farol_background;
layout(location = 0) out highp vec4 farol_color;
//# main
farol_color = farol_background;
