// One texel of each block, which stands for it where indirect light is gathered: the first of the block's that has a point
// Kopf et al. 2007, Joint Bilateral Upsampling
uniform highp sampler2D farol_settled;
uniform highp sampler2D farol_placeNormals;
uniform highp sampler2D farol_placeFaces;
uniform int farol_block; // texels along a side
layout(location = 0) out highp vec4 farol_place; // its number in the block and 1, or 0 where there is none
layout(location = 1) out highp vec4 farol_texelNormal;
layout(location = 2) out highp vec4 farol_texelFace;

void main() {
  ivec2 corner = farol_block * ivec2(gl_FragCoord.xy);
  ivec2 middle = ivec2((farol_block - 1) / 2);
  farol_place = farol_texelNormal = farol_texelFace = vec4(0.0);
  for (int i = -1; i < farol_block * farol_block; i++) {
    ivec2 within = i < 0 ? middle : ivec2(i % farol_block, i / farol_block);
    vec4 place = texelFetch(farol_settled, corner + within, 0);
    if (place.w <= 0.0) continue;
    farol_place = vec4(place.xyz, float(within.x + farol_block * within.y + 1));
    farol_texelNormal = texelFetch(farol_placeNormals, corner + within, 0);
    farol_texelFace = texelFetch(farol_placeFaces, corner + within, 0);
    return;
  }
}
