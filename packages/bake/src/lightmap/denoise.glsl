// One step of an edge-avoiding wavelet filter: neighbouring texels count by their distance and normals in the scene
// Dammertz et al. 2010, Edge-Avoiding À-Trous Wavelet Transform; Schied et al. 2017, Variance-Guided Filtering
uniform highp sampler2D farol_positions;
uniform highp sampler2D farol_texelNormals;
uniform highp sampler2D farol_light;
uniform int farol_step; // distance between the filter's taps (texels)
uniform float farol_texelSize; // side of a texel (m)
layout(location = 0) out highp vec4 farol_filtered;

float farol_luminance(const in vec3 colour) {
  return dot(colour, vec3(0.2126, 0.7152, 0.0722));
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 size = textureSize(farol_light, 0);
  vec4 center = texelFetch(farol_light, texel, 0);
  if (center.a < 0.0) {
    farol_filtered = center;
    return;
  }
  vec3 position = texelFetch(farol_positions, texel, 0).xyz;
  vec3 normal = texelFetch(farol_texelNormals, texel, 0).xyz;
  float variance = 0.0;
  float weights = 0.0;
  for (int y = -1; y <= 1; y++)
    for (int x = -1; x <= 1; x++) {
      float around = texelFetch(farol_light, clamp(texel + ivec2(x, y), ivec2(0), size - 1), 0).a;
      float weight = around < 0.0 ? 0.0 : exp2(-float(x * x + y * y));
      variance += weight * max(around, 0.0);
      weights += weight;
    }
  // quasirandom samples vary less than their variance suggests
  float deviation = sqrt(variance / weights) + 1e-7;
  float luminance = farol_luminance(center.rgb);
  float reach = farol_texelSize * float(farol_step);
  vec4 sum = center * vec4(vec3(0.140625), 0.140625 * 0.140625);
  float whole = 0.140625;
  for (int y = -2; y <= 2; y++)
    for (int x = -2; x <= 2; x++) {
      ivec2 at = texel + farol_step * ivec2(x, y);
      if (x == 0 && y == 0 || any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size))) continue;
      vec4 light = texelFetch(farol_light, at, 0);
      if (light.a < 0.0) continue;
      vec3 away = texelFetch(farol_positions, at, 0).xyz - position;
      float far = length(away) / (reach * length(vec2(x, y)));
      float lift = abs(dot(away, normal)) / (farol_texelSize * float(farol_step));
      float facing = max(dot(texelFetch(farol_texelNormals, at, 0).xyz, normal), 0.0);
      float weight = exp(-lift - abs(farol_luminance(light.rgb) - luminance) / deviation);
      weight *= pow(facing, 64.0) * (1.0 - smoothstep(1.8, 2.6, far));
      float kernel = (x == 0 ? 0.375 : abs(x) == 1 ? 0.25 : 0.0625) * (y == 0 ? 0.375 : abs(y) == 1 ? 0.25 : 0.0625);
      weight *= kernel;
      sum += light * vec4(vec3(weight), weight * weight);
      whole += weight;
    }
  farol_filtered = sum / vec4(vec3(whole), whole * whole);
}
