// Lays a colour over what is far away.
// Farol
#include "unproject"
#include "viewport"
uniform highp sampler2D example_depth;
uniform vec2 example_range; // distances (m): where the fade begins, where it covers all
layout(location = 0) out highp vec4 example_color;
//? example_shareAt(-5.0, vec2(4.0, 6.0)) == 0.5
float example_shareAt(const in float viewZ, const in vec2 range) {
  return clamp((-viewZ - range.x) / (range.y - range.x), 0.0, 1.0);
}
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy - farol_offset);
float depth = texelFetch(example_depth, pixel, 0).r;
example_color = vec4(0.5, 0.6, 0.7, example_shareAt(farol_viewZ(depth), example_range));
