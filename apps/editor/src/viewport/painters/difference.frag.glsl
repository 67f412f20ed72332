// Amplified difference of two sRGB-encoded images, per channel.
// Farol
precision highp float;
precision highp sampler2D;
uniform sampler2D a;
uniform sampler2D b;
uniform float gain;
out vec4 color;

// linear to sRGB; IEC 61966-2-1
vec3 encoded(const in vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 difference = abs(encoded(texelFetch(a, pixel, 0).rgb) - encoded(texelFetch(b, pixel, 0).rgb));
  color = vec4(difference * gain, 1.0);
}
