// Copies a level of an image that a light throws into its region of the atlas, and round it a border by the image's own
// wrapping; of a cube (FAROL_IMAGE_KIND 1) six faces, three by two, with borders; of a photometric profile (2) from 0
// to 180° and from 0 to 360°, both ends in the middle of texels.
// Farol; the faces lie as farol_cubeFace in lightShadow.glsl has them
#if FAROL_IMAGE_KIND == 1
uniform highp samplerCube farol_cookieImage;
#else
uniform highp sampler2D farol_cookieImage;
#endif
// texels; xy: corner, border left out; zw: size, of a cube's face
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
