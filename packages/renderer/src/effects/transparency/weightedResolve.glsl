// Blends the weighted mean of all transparent layers over the opaque picture.
// McGuire and Bavoil 2013, Weighted Blended Order-Independent Transparency, https://jcgt.org/published/0002/02/09/
uniform highp sampler2D farol_layers; // rgb: weighted sum of colours; a: transmittance of all layers, 0 to 1
uniform highp sampler2D farol_weights; // r: sum of the weights of the transparent layers
layout(location = 0) out highp vec4 farol_color;
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy);
vec4 layers = texelFetch(farol_layers, pixel, 0);
if (layers.a >= 1.0) discard;
float total = texelFetch(farol_weights, pixel, 0).r;
float opacity = 1.0 - layers.a;
// sums beyond half floats count as the greatest half float
farol_color = vec4(min(layers.rgb, 65504.0) / max(min(total, 65504.0), 1e-5) * opacity, opacity);
