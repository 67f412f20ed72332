// Writes a picture of more texels than pixels, with depth, to the host's target: the mean of each pixel's texels.
// Yang et al. 2009, Amortized Supersampling
#include "displayTransfer"
#include "frameSize"
#include "viewport"
uniform highp sampler2D farol_finer; // the finer picture, in linear light
uniform highp vec2 farol_finerSize; // size of the drawn part of farol_finer (texels)
uniform highp vec2 farol_largeSize; // size of the large picture (pixels)
uniform highp sampler2D farol_pictureDepth; // depth of the small picture
uniform highp vec2 farol_scaling; // pixels of the small picture per pixel of the large one
uniform bool farol_isLinear; // whether the host's target is to be linear light, else encoded for the display
layout(location = 0) out highp vec4 farol_color;
//# main
vec2 place = gl_FragCoord.xy - farol_offset;
vec2 texels = farol_finerSize / farol_largeSize;
// half width of the box filter, half a texel at least, which is bilinear filtering
vec2 reach = 0.5 * max(texels, 1.0);
vec2 low = place * texels - reach;
vec2 high = place * texels + reach;
ivec2 first = ivec2(floor(low));
farol_color = vec4(0.0);
float total = 0.0;
for (int y = 0; y < 4; y++) for (int x = 0; x < 4; x++) {
  ivec2 at = first + ivec2(x, y);
  vec2 inside = max(min(vec2(at) + 1.0, high) - max(vec2(at), low), 0.0);
  if (inside.x * inside.y == 0.0) continue;
  farol_color += inside.x * inside.y * texelFetch(farol_finer, clamp(at, ivec2(0), ivec2(farol_finerSize) - 1), 0);
  total += inside.x * inside.y;
}
farol_color /= total;
if (!farol_isLinear) farol_color = farol_toDisplay(farol_color);
gl_FragDepth = texelFetch(farol_pictureDepth, min(ivec2(place * farol_scaling), ivec2(farol_frameSize) - 1), 0).r;
