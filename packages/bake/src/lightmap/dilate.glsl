// Gives texels without light the light of their neighbours
// Fills seams for bilinear filtering and mipmaps
uniform highp sampler2D farol_light;
layout(location = 0) out highp vec4 farol_dilated;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 size = textureSize(farol_light, 0);
  farol_dilated = texelFetch(farol_light, texel, 0);
  if (farol_dilated.a >= 0.0) return;
  vec4 sum = vec4(0.0);
  float whole = 0.0;
  for (int y = -1; y <= 1; y++)
    for (int x = -1; x <= 1; x++) {
      ivec2 at = texel + ivec2(x, y);
      if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size))) continue;
      vec4 light = texelFetch(farol_light, at, 0);
      float weight = light.a < 0.0 ? 0.0 : x == 0 || y == 0 ? 1.0 : 0.5;
      sum += weight * light;
      whole += weight;
    }
  if (whole > 0.0) farol_dilated = sum / whole;
}
