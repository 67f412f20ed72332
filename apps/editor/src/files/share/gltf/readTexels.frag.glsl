precision highp float;
precision highp sampler2D;
uniform sampler2D source;
uniform bool encode;
in vec2 uvOfTexel;
out vec4 texel;

// Linear to sRGB; IEC 61966-2-1.
vec3 encodeSRGB(vec3 linear) {
  return mix(pow(linear, vec3(1.0 / 2.4)) * 1.055 - 0.055, linear * 12.92, lessThanEqual(linear, vec3(0.0031308)));
}

void main() {
  texel = clamp(textureLod(source, uvOfTexel, 0.0), 0.0, 1.0);
  if (encode) texel.rgb = encodeSRGB(texel.rgb);
}
