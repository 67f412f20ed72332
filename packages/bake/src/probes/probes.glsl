// Light at points as nine spherical harmonics: sums over samples, and the count of rays that hit back faces
// Ramamoorthi and Hanrahan 2001, An Efficient Representation for Irradiance Environment Maps
#include "tables"
#include "random"
#include "traverse"
#include "sky"
#include "lightTable"
uniform highp sampler2D farol_points;
uniform highp sampler2DArray farol_emission;
uniform highp sampler2DArray farol_reflected;
uniform int farol_emitterCount;
uniform int farol_firstSample;
layout(location = 0) out highp vec4 farol_sh0;
layout(location = 1) out highp vec4 farol_sh1;
layout(location = 2) out highp vec4 farol_sh2;
layout(location = 3) out highp vec4 farol_sh3;
layout(location = 4) out highp vec4 farol_sh4;
layout(location = 5) out highp vec4 farol_sh5;
layout(location = 6) out highp vec4 farol_sh6;

vec3 farol_sh[9];
float farol_backs;

void farol_add(const in vec3 light, const in vec3 d) {
  farol_sh[0] += 0.282095 * light;
  farol_sh[1] += 0.488603 * d.y * light;
  farol_sh[2] += 0.488603 * d.z * light;
  farol_sh[3] += 0.488603 * d.x * light;
  farol_sh[4] += 1.092548 * d.x * d.y * light;
  farol_sh[5] += 1.092548 * d.y * d.z * light;
  farol_sh[6] += 0.315392 * (3.0 * d.z * d.z - 1.0) * light;
  farol_sh[7] += 1.092548 * d.x * d.z * light;
  farol_sh[8] += 0.546274 * (d.x * d.x - d.y * d.y) * light;
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 point = texelFetch(farol_points, texel, 0);
  if (point.w <= 0.0) discard;
  for (int i = 0; i < 9; i++) farol_sh[i] = vec3(0.0);
  farol_backs = 0.0;
  ivec2 list = farol_lightList(point.xyz);
  for (int i = 0; i < SAMPLES; i++) {
    vec3 along = farol_sphere(farol_sample2(texel, farol_firstSample + i, 1));
    vec3 light = vec3(0.0);
    FarolHit hit = farol_trace(point.xyz, along, 1e30);
    if (hit.triangle < 0) light = farol_sky(along);
    else if (farol_hitShines(hit)) {
      vec3 at = farol_hitPlace(hit);
      if (at.z >= 0.0) {
        light = textureLod(farol_reflected, at, 0.0).rgb;
        if (farol_emitterCount > 0) light += textureLod(farol_emission, at, 0.0).rgb;
      }
    } else farol_backs += 1.0;
    // the solid angle of a sphere is 4 pi
    farol_add(12.566371 * light, along);
    for (int l = 0; l < farol_endlessLights + list.y; l++) {
      int which = farol_listedLight(list, l);
      vec4 place = farol_table(farol_lights, 9 * which);
      vec3 toLight = place.w == 0.0 ? farol_table(farol_lights, 9 * which + 2).xyz : normalize(place.xyz - point.xyz);
      vec2 u = farol_sample2(texel, farol_firstSample + i, 16 + which);
      // irradiance of a surface that faces the light
      farol_add(farol_unshadowed(farol_arrival(which, point.xyz, toLight, u), point.xyz, point.xyz), toLight);
    }
  }
  farol_sh0 = vec4(farol_sh[0], farol_sh[1].r);
  farol_sh1 = vec4(farol_sh[1].gb, farol_sh[2].rg);
  farol_sh2 = vec4(farol_sh[2].b, farol_sh[3]);
  farol_sh3 = vec4(farol_sh[4], farol_sh[5].r);
  farol_sh4 = vec4(farol_sh[5].gb, farol_sh[6].rg);
  farol_sh5 = vec4(farol_sh[6].b, farol_sh[7]);
  farol_sh6 = vec4(farol_sh[8], farol_backs);
}
