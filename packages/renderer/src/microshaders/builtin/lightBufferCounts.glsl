// Shows what a technique with a light buffer shades at each pixel: its materials, and its share of the light buffer's texel.
// Farol
#include "heatMap"
#include "heatScale"
uniform highp sampler2D farol_sums0;
uniform highp sampler2D farol_overdrawMap;
uniform highp vec4 farol_lightGrid; // texels a pixel (x, y); where the picture lies in the target (pixels)
//# main
vec2 pixel = gl_FragCoord.xy - farol_lightGrid.zw;
float counted = texelFetch(farol_sums0, ivec2(pixel * farol_lightGrid.xy), 0).r * farol_lightGrid.x * farol_lightGrid.y;
counted += texelFetch(farol_overdrawMap, ivec2(pixel), 0).r;
gl_FragColor = vec4(farol_heatMap(counted * farol_heatScale), 1.0);
