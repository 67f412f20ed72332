// Writes only depth to the host's target, from a depth texture, slightly farther so that equal depths pass.
// Farol
#include "viewport"
#include "depthMode"
uniform highp sampler2D farol_sceneDepth;
//# main
float depth = texelFetch(farol_sceneDepth, ivec2(gl_FragCoord.xy - farol_offset), 0).r;
if (farol_isEmpty(depth)) discard;
gl_FragColor = vec4(0.0);
gl_FragDepth = farol_depthMode.x > 0.0 ? max(depth - 2.4e-7, 0.0) : min(depth + 2.4e-7, 1.0);
