precision highp float;
precision highp sampler2D;
// Fog by a march of 512 steps from the eye to what each pixel shows, apart from the product's: shadows by rays through
// the boxes of the scene, lights as three documents them.
uniform sampler2D picture;
uniform sampler2D depths;
uniform mat4 clipToView;
uniform mat4 viewToWorld;
uniform vec4 fog; // extinction (1/m), anisotropy, height (m), falloff (m)
uniform vec3 albedo;
uniform float farthest; // distance at which the fog ends (m)
uniform vec3 ambient; // irradiance
uniform vec3 sunDirection; // towards the sun
uniform vec3 sunColor;
uniform vec3 lampPosition[LAMPS];
uniform vec3 lampColor[LAMPS];
uniform float lampRange[LAMPS];
uniform vec4 lampCone[LAMPS]; // direction from the lamp, cosine of the angle; -1 for a point light
uniform float lampShadow[LAMPS];
uniform vec3 boxLow[BOXES];
uniform vec3 boxHigh[BOXES];
uniform mat4 volumeInverse;
uniform vec4 volume; // extinction (1/m), softness, 1 for a sphere
out vec4 color;

bool isLit(vec3 from, vec3 to) {
  vec3 way = to - from;
  for (int i = 0; i < BOXES; i++) {
    vec3 a = (boxLow[i] - from) / way, b = (boxHigh[i] - from) / way;
    vec3 low = min(a, b), high = max(a, b);
    float enter = max(max(low.x, low.y), max(low.z, 0.0));
    if (enter < min(min(high.x, high.y), min(high.z, 1.0))) return false;
  }
  return true;
}

float scattering(float cosine) {
  float g = fog.y;
  return (1.0 - g * g) / (12.566370614 * pow(1.0 + g * g - 2.0 * g * cosine, 1.5));
}

vec2 extinctionAt(vec3 at) {
  float general = fog.x * (fog.w > 0.0 ? exp(-max(at.y - fog.z, 0.0) / fog.w) : 1.0);
  vec3 place = 2.0 * abs((volumeInverse * vec4(at, 1.0)).xyz);
  float away = volume.z > 0.0 ? length(place) : max(place.x, max(place.y, place.z));
  return vec2(general, volume.x * clamp((1.0 - away) / volume.y, 0.0, 1.0));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(depths, pixel, 0).r;
  vec2 uv = gl_FragCoord.xy / vec2(textureSize(picture, 0));
  vec4 there = clipToView * vec4(uv * 2.0 - 1.0, depth * 2.0 - 1.0, 1.0);
  vec3 end = there.xyz / there.w;
  if (depth >= 1.0 || -end.z > farthest) end *= farthest / -end.z;
  vec3 eye = viewToWorld[3].xyz;
  vec3 way = (viewToWorld * vec4(end, 1.0)).xyz - eye;
  vec3 ray = normalize(way);
  float step = length(way) / 512.0;
  vec3 light = vec3(0.0);
  float through = 1.0;
  for (int i = 0; i < 512; i++) {
    vec3 at = eye + way * ((float(i) + 0.5) / 512.0);
    vec2 extinction = extinctionAt(at);
    float sum = extinction.x + extinction.y;
    if (sum <= 0.0) continue;
    vec3 arriving = ambient / 3.14159265;
    if (isLit(at, at + sunDirection * 100.0)) arriving += sunColor * scattering(dot(sunDirection, ray));
    for (int k = 0; k < LAMPS; k++) {
      vec3 toLamp = lampPosition[k] - at;
      float away = length(toLamp);
      if (away >= lampRange[k]) continue;
      float window = 1.0 - pow(away / lampRange[k], 4.0);
      float cone = lampCone[k].w < 0.0 ? 1.0 : smoothstep(lampCone[k].w, 1.0, dot(-toLamp / away, lampCone[k].xyz));
      if (cone <= 0.0 || (lampShadow[k] > 0.0 && !isLit(at, lampPosition[k]))) continue;
      float factor = cone * window * window / max(away * away, 0.01);
      arriving += lampColor[k] * factor * scattering(dot(toLamp / away, ray));
    }
    float passes = exp(-sum * step);
    light += through * (1.0 - passes) / sum * (extinction.x * albedo + extinction.y) * arriving;
    through *= passes;
  }
  color = vec4(texelFetch(picture, pixel, 0).rgb * through + light, 1.0);
}
