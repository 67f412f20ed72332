// Lanczos's kernel of three lobes in nine bilinear reads: the rows and columns around the place, without corners.
// Duchon 1979, Lanczos Filtering in One and Two Dimensions
//? farol_lanczos(0.0) == 1.0
//? farol_lanczos(1.0) == 0.0
//? farol_lanczos(-1.5) == -0.135094912
float farol_lanczos(const in float x) {
  float a = 3.14159265 * abs(x);
  if (a < 0.1) return 1.0 - a * a * (5.0 / 27.0); // series near 0, where the quotient of sines is imprecise
  return 3.0 * sin(a) * sin(a / 3.0) / (a * a);
}

// uv: 0 to 1 over the used part of the image; drawn: size of that part (texels)
vec4 farol_lanczosCross(const in highp sampler2D image, const in vec2 uv, const in vec2 drawn) {
  vec2 size = vec2(textureSize(image, 0));
  vec2 place = uv * drawn;
  vec2 first = floor(place - 0.5) + 0.5;
  vec2 f = place - first;
  vec2 last = vec2(farol_lanczos(f.x - 1.0), farol_lanczos(f.y - 1.0));
  vec2 middle = vec2(farol_lanczos(f.x), farol_lanczos(f.y)) + last;
  vec2 at = min(first + last / middle, drawn - 0.5) / size;
  vec4 sum = texture(image, at) * middle.x * middle.y;
  float total = middle.x * middle.y;
  for (int i = 0; i < 4; i++) {
    float off = float(i < 2 ? i - 2 : i);
    vec2 weight = vec2(farol_lanczos(f.x - off), farol_lanczos(f.y - off)) * middle.yx;
    vec2 there = min(first + off, drawn - 0.5) / size;
    sum += texture(image, vec2(there.x, at.y)) * weight.x + texture(image, vec2(at.x, there.y)) * weight.y;
    total += weight.x + weight.y;
  }
  return sum / total;
}
