// Shows the red channel of a buffer with a texel for each pixel.
// Farol
#include "viewport"
uniform highp sampler2D farol_buffer;
//# main
gl_FragColor = vec4(vec3(texelFetch(farol_buffer, ivec2(gl_FragCoord.xy - farol_offset), 0).r), 1.0);
