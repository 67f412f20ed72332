// Shows one sum of the light buffer in a panel.
// Engel 2009, The Light Pre-Pass Renderer
uniform highp sampler2D farol_sums0;
uniform highp sampler2D farol_sums1;
uniform highp sampler2D farol_sums2;
uniform highp sampler2D farol_sums3;
uniform highp vec2 farol_size; // size of the light buffer (texels)
uniform highp vec4 farol_panel; // corner and size of the panel (pixels)
uniform int farol_sum; // 0 diffuse, 1 specular, 2 specular at grazing angles, 3 rest
//# main
ivec2 texel = ivec2((gl_FragCoord.xy - farol_panel.xy) / farol_panel.zw * farol_size);
vec4 diffuse = texelFetch(farol_sums0, texel, 0);
vec4 rest = texelFetch(farol_sums1, texel, 0);
vec4 specular = texelFetch(farol_sums2, texel, 0);
vec3 sum = farol_sum == 0 ? diffuse.rgb : farol_sum == 1 ? specular.rgb
  : farol_sum == 2 ? vec3(diffuse.a, rest.a, specular.a) : rest.rgb + texelFetch(farol_sums3, texel, 0).rgb;
gl_FragColor = vec4(min(sum, 65504.0), 1.0);
#include <tonemapping_fragment>
#include <colorspace_fragment>
