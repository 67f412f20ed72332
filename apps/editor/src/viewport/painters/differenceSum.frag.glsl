// For each block of 16 by 16 pixels: sum of squared differences of all channels, largest difference, number of pixels
// off by more than 2/255.
// Farol
precision highp float;
precision highp sampler2D;
uniform sampler2D a;
uniform sampler2D b;
out vec4 sums;

// linear to sRGB; IEC 61966-2-1
vec3 encoded(const in vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * 16;
  ivec2 end = min(first + 16, textureSize(a, 0));
  sums = vec4(0.0);
  for (int y = first.y; y < end.y; y++) {
    for (int x = first.x; x < end.x; x++) {
      ivec2 pixel = ivec2(x, y);
      vec3 difference = abs(encoded(texelFetch(a, pixel, 0).rgb) - encoded(texelFetch(b, pixel, 0).rgb));
      float largest = max(difference.r, max(difference.g, difference.b));
      sums += vec4(dot(difference, difference), 0.0, largest > 2.0 / 255.0 ? 1.0 : 0.0, 0.0);
      sums.y = max(sums.y, largest);
    }
  }
}
