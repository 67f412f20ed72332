// Chooses the texel of each block at which indirect light is gathered: the one with the most neighbours outside the
// chart, so that the chart's border, where light changes most, is interpolated, not extrapolated
// Kopf et al. 2007, Joint Bilateral Upsampling
uniform highp sampler2D farol_settled;
uniform highp sampler2D farol_placeNormals;
uniform highp sampler2D farol_placeFaces;
uniform int farol_block; // texels along a side of a block
layout(location = 0) out highp vec4 farol_place; // xyz: point of the texel; w: its index in the block + 1; 0 for none
layout(location = 1) out highp vec4 farol_texelNormal;
layout(location = 2) out highp vec4 farol_texelFace;

bool farol_hasPoint(const in ivec2 texel) {
  if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, textureSize(farol_settled, 0)))) return false;
  return texelFetch(farol_settled, texel, 0).w > 0.0;
}

void main() {
  ivec2 corner = farol_block * ivec2(gl_FragCoord.xy);
  farol_place = farol_texelNormal = farol_texelFace = vec4(0.0);
  int most = -1;
  ivec2 chosen = ivec2(0);
  for (int i = 0; i < farol_block * farol_block; i++) {
    ivec2 within = ivec2(i % farol_block, i / farol_block);
    if (!farol_hasPoint(corner + within)) continue;
    int border = 0;
    for (int k = 0; k < 9; k++) if (!farol_hasPoint(corner + within + ivec2(k % 3, k / 3) - 1)) border++;
    if (border <= most) continue;
    most = border;
    chosen = within;
  }
  if (most < 0) return;
  farol_place = vec4(texelFetch(farol_settled, corner + chosen, 0).xyz, float(chosen.x + farol_block * chosen.y + 1));
  farol_texelNormal = texelFetch(farol_placeNormals, corner + chosen, 0);
  farol_texelFace = texelFetch(farol_placeFaces, corner + chosen, 0);
}
