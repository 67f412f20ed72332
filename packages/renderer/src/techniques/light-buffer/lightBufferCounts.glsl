// Heat map of a technique with a light buffer: at each pixel its draws, and its share of the lights of its texel.
// Farol
#include "heatMap"
#include "heatScale"
#include "viewport"
uniform highp sampler2D farol_sums0;
uniform highp sampler2D farol_overdrawMap;
uniform vec2 farol_size; // size of the light buffer (texels)
uniform highp vec4 farol_lightGrid; // xy: light buffer texels per pixel; zw: offset of the picture (pixels)
//# main
ivec2 texel = ivec2((gl_FragCoord.xy - farol_lightGrid.zw) * farol_lightGrid.xy);
float counted = texelFetch(farol_sums0, min(texel, ivec2(farol_size) - 1), 0).r
  * farol_lightGrid.x * farol_lightGrid.y;
counted += texelFetch(farol_overdrawMap, ivec2(gl_FragCoord.xy - farol_offset), 0).r;
gl_FragColor = vec4(farol_heatMap(counted * farol_heatScale), 1.0);
