// Shows counts as a heat map.
// Farol
#include "heatMap"
#include "heatScale"
#include "viewport"
uniform highp sampler2D farol_overdrawMap;
//# main
gl_FragColor = vec4(
  farol_heatMap(texelFetch(farol_overdrawMap, ivec2(gl_FragCoord.xy - farol_offset), 0).r * farol_heatScale), 1.0);
