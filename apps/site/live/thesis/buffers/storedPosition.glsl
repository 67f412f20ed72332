// World position as an attachment stores it, as depth gives it back, or how far apart they are.
// Thesis 2.2.3.1.2 and 3.1.1
#include "unproject"
#include "viewport"
uniform highp vec2 farol_size;
uniform highp sampler2D thesis_stored; // view-space position (m); alpha 1 where there is a surface
uniform highp sampler2D thesis_depth;
uniform highp mat4 thesis_viewInverse;
uniform highp float thesis_steps; // depth is rounded to one part in so many; 0: to none
uniform highp float thesis_gain; // how many times an error is enlarged
uniform highp int thesis_show; // 0 stored, 1 rebuilt, 2 distance between them
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy - farol_offset);
vec4 stored = texelFetch(thesis_stored, pixel, 0);
float depth = texelFetch(thesis_depth, pixel, 0).r;
if (thesis_steps > 0.0) depth = floor(depth * thesis_steps + 0.5) / thesis_steps;
vec3 rebuilt = farol_unproject((vec2(pixel) + 0.5) / farol_size, depth);
vec3 shown = vec3(0.0);
if (stored.a > 0.0) {
  if (thesis_show == 2) shown = vec3(distance(rebuilt, stored.xyz) * thesis_gain);
  else shown = fract((thesis_viewInverse * vec4(thesis_show == 0 ? stored.xyz : rebuilt, 1.0)).xyz * 0.5);
}
gl_FragColor = vec4(shown, 1.0);
