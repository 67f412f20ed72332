// Vignette: factor of the image's brightness, 1 at the centre, less towards the corners.
// Farol
uniform vec2 lantern_size; // size of the picture (pixels)
layout(location = 0) out highp vec4 lantern_share;
//# main
vec2 fromMiddle = gl_FragCoord.xy / lantern_size - 0.5;
lantern_share = vec4(vec3(1.0 - 1.6 * dot(fromMiddle, fromMiddle)), 1.0);
