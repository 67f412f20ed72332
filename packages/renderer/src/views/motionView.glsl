// Motion of each pixel since the last frame: direction as hue (red to the right, then counterclockwise), length as
// brightness.
// Baker et al. 2011, A Database and Evaluation Methodology for Optical Flow (colour coding)
#include "taaDepth"
#include "viewport"
uniform bool farol_hasPast;
uniform highp float farol_fullMotion; // motion (pixels) of full brightness
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy - farol_offset);
vec2 motion = farol_hasPast ? farol_wayOf(pixel, farol_distanceAt(pixel)).xy * farol_frameSize : vec2(0.0);
float hue = atan(motion.y, motion.x) * 0.9549296586; // hue from 0 to 6 for a whole turn
vec3 colour = clamp(abs(mod(hue + vec3(0.0, 4.0, 2.0), 6.0) - 3.0) - 1.0, 0.0, 1.0);
// length in pixels; below 0.01 it is a rounding error, and black
float size = length(motion);
gl_FragColor = vec4(size < 0.01 ? vec3(0.0) : colour * min(size / farol_fullMotion, 1.0), 1.0);
