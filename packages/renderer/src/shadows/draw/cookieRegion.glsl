// Copies a mipmap level of an image that a light projects into its region of the atlas, with a border by the image's
// wrapping; FAROL_IMAGE_KIND 1: six faces of a cube, three by two, each with a border; 2: a photometric profile, 0 to
// 180° by 0 to 360°, first and last at texel centres.
// Farol; faces in the order and orientation of farol_cubeFace in lightShadow.glsl
#if FAROL_IMAGE_KIND == 1
uniform highp samplerCube farol_cookieImage;
#else
uniform highp sampler2D farol_cookieImage;
#endif
// region (texels), without border; xy: corner; zw: size (cube: of one face)
uniform highp vec4 farol_cookieRegion;
uniform highp float farol_cookieFlip; // 1, or -1 to mirror the image in x
uniform highp float farol_cookieLevel; // mipmap level of the image
layout(location = 0) out highp vec4 farol_cookie;
//# main
vec2 at = gl_FragCoord.xy - farol_cookieRegion.xy;
#if FAROL_IMAGE_KIND == 1
vec2 spacing = farol_cookieRegion.zw + 2.0;
vec2 cell = floor((at + 1.0) / spacing);
vec2 across = (at - cell * spacing) / farol_cookieRegion.zw * 2.0 - 1.0;
int face = int(cell.x + 3.0 * cell.y + 0.5);
float side = (face & 1) == 0 ? 1.0 : -1.0;
vec3 direction = face < 2 ? vec3(side, across.y, side * across.x)
  : face < 4 ? vec3(side * across.x, side, across.y) : vec3(-side * across.x, across.y, side);
farol_cookie = textureLod(farol_cookieImage, vec3(farol_cookieFlip * direction.x, direction.yz), farol_cookieLevel);
#elif FAROL_IMAGE_KIND == 2
vec2 size = vec2(textureSize(farol_cookieImage, 0));
vec2 share = (at - 0.5) / max(farol_cookieRegion.zw - 1.0, 1.0);
farol_cookie = textureLod(farol_cookieImage,
  vec2((share.x * (size.x - 1.0) + 0.5) / size.x, fract(share.y) + 0.5 / size.y), 0.0);
#else
farol_cookie = textureLod(farol_cookieImage, at / farol_cookieRegion.zw, farol_cookieLevel);
#endif
