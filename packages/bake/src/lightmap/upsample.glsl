// Light of texels between those at which it was gathered: a plane through the light of neighbours on the same surface,
// fitted by weighted least squares
// Levin 1998, The Approximation Power of Moving Least-Squares; Kopf et al. 2007, Joint Bilateral Upsampling
uniform highp sampler2D farol_settled;
uniform highp sampler2D farol_placeNormals;
uniform highp sampler2D farol_positions; // positions of the blocks (world space, m)
uniform highp sampler2D farol_texelNormals;
uniform highp sampler2D farol_light;
uniform int farol_block;
uniform float farol_texelSize; // side of a block (m)
layout(location = 0) out highp vec4 farol_upsampled;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 place = texelFetch(farol_settled, texel, 0);
  farol_upsampled = vec4(0.0, 0.0, 0.0, -1.0);
  if (place.w <= 0.0) return;
  vec3 normal = texelFetch(farol_placeNormals, texel, 0).xyz;
  ivec2 own = texel / farol_block;
  float whole = 0.0;
  vec2 mean = vec2(0.0); // weighted sum of offsets to neighbours (blocks)
  vec3 squares = vec3(0.0); // weighted sums of x², y² and xy of the offsets
  vec4 sum = vec4(0.0);
  vec4 sumX = vec4(0.0);
  vec4 sumY = vec4(0.0);
  vec4 least = vec4(1e30);
  vec4 greatest = vec4(0.0);
  for (int y = -1; y <= 1; y++)
    for (int x = -1; x <= 1; x++) {
      ivec2 block = own + ivec2(x, y);
      if (any(lessThan(block, ivec2(0))) || any(greaterThanEqual(block, textureSize(farol_light, 0)))) continue;
      vec4 light = texelFetch(farol_light, block, 0);
      vec4 other = texelFetch(farol_positions, block, 0);
      if (other.w <= 0.0 || light.a < 0.0) continue;
      int number = int(other.w) - 1;
      ivec2 at = farol_block * block + ivec2(number % farol_block, number / farol_block);
      vec2 away = vec2(at - texel) / float(farol_block);
      vec2 tent = max(1.0 - abs(away) / 1.5, 0.0);
      vec3 path = other.xyz - place.xyz;
      float far = length(path) / (farol_texelSize * max(length(away), 0.5));
      float facing = max(dot(texelFetch(farol_texelNormals, block, 0).xyz, normal), 0.0);
      float weight = tent.x * tent.y / (dot(away, away) + 0.01) * pow(facing, 16.0) * (1.0 - smoothstep(1.8, 2.6, far));
      weight *= exp(-abs(dot(path, normal)) / farol_texelSize);
      // the texel's own block has a small weight, in case no neighbour is on the surface
      if (x == 0 && y == 0) weight += 1e-6;
      else if (weight < 1e-6) continue;
      whole += weight;
      mean += weight * away;
      squares += weight * vec3(away * away, away.x * away.y);
      sum += weight * light;
      sumX += weight * away.x * light;
      sumY += weight * away.y * light;
      least = min(least, light);
      greatest = max(greatest, light);
    }
  if (whole == 0.0) return;
  mean /= whole;
  sum /= whole;
  squares = squares / whole - vec3(mean * mean, mean.x * mean.y);
  squares.xy += 0.02; // regularisation, for neighbours in one line or a single one
  vec2 share = vec2(squares.y * mean.x - squares.z * mean.y, squares.x * mean.y - squares.z * mean.x);
  share /= squares.x * squares.y - squares.z * squares.z;
  vec4 plane = sum - share.x * (sumX / whole - mean.x * sum) - share.y * (sumY / whole - mean.y * sum);
  farol_upsampled = clamp(plane, least, greatest);
}
