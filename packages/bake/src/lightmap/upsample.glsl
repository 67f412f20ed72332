// Light of texels between those that stand for blocks, of neighbours that lie on the same surface
// Kopf et al. 2007, Joint Bilateral Upsampling
uniform highp sampler2D farol_settled;
uniform highp sampler2D farol_placeNormals;
uniform highp sampler2D farol_positions; // of the blocks
uniform highp sampler2D farol_texelNormals;
uniform highp sampler2D farol_light;
uniform int farol_block;
uniform float farol_texelSize; // m, of a block
layout(location = 0) out highp vec4 farol_upsampled;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 place = texelFetch(farol_settled, texel, 0);
  farol_upsampled = vec4(0.0, 0.0, 0.0, -1.0);
  if (place.w <= 0.0) return;
  vec3 normal = texelFetch(farol_placeNormals, texel, 0).xyz;
  ivec2 own = texel / farol_block;
  vec4 sum = vec4(0.0);
  float whole = 0.0;
  for (int y = -1; y <= 1; y++)
    for (int x = -1; x <= 1; x++) {
      ivec2 block = own + ivec2(x, y);
      if (any(lessThan(block, ivec2(0))) || any(greaterThanEqual(block, textureSize(farol_light, 0)))) continue;
      vec4 light = texelFetch(farol_light, block, 0);
      vec4 other = texelFetch(farol_positions, block, 0);
      if (other.w <= 0.0 || light.a < 0.0) continue;
      int number = int(other.w) - 1;
      ivec2 at = farol_block * block + ivec2(number % farol_block, number / farol_block);
      vec2 away = abs(vec2(at - texel)) / float(farol_block); // blocks
      vec2 tent = max(1.0 - away, 0.0);
      vec3 path = other.xyz - place.xyz;
      float far = length(path) / (farol_texelSize * max(length(away), 0.5));
      float facing = max(dot(texelFetch(farol_texelNormals, block, 0).xyz, normal), 0.0);
      float weight = tent.x * tent.y * pow(facing, 16.0) * (1.0 - smoothstep(1.8, 2.6, far));
      weight *= exp(-abs(dot(path, normal)) / farol_texelSize);
      // what stands for the texel's block, where nothing fits
      if (x == 0 && y == 0) weight += 1e-6;
      sum += weight * light;
      whole += weight;
    }
  if (whole > 0.0) farol_upsampled = sum / whole;
}
