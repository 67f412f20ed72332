// Scattering and extinction of the fog at a point: height, drifting noise, local volumes.
// Wronski 2014, Volumetric Fog; O'Neill 2014, PCG (hash of the noise, as Jarzynski and Olano 2020 name it: pcg3d)
#define FAROL_MOST_VOLUMES 16
uniform highp vec4 farol_fogScatter; // rgb: scattering coefficient (1/m); a: extinction (1/m)
// x: height of full density (m); y: 1 / falloff (1/m), 0: no falloff; z: strength of the noise; w: 1 / its size (1/m)
uniform highp vec4 farol_fogHeight;
uniform highp vec3 farol_fogDrift; // drift of the noise (m)
uniform highp int farol_fogVolumes; // number of local volumes
uniform highp mat4 farol_fogVolumeInverse[FAROL_MOST_VOLUMES]; // from world space to each volume's unit box
uniform highp vec4 farol_fogVolumeScatter[FAROL_MOST_VOLUMES]; // as farol_fogScatter, below 0 to remove fog
uniform highp vec2 farol_fogVolumeShape[FAROL_MOST_VOLUMES]; // x: 1 for a sphere, 0 for a box; y: 1 / softness

float farol_fogHash(const in ivec3 cell) {
  uvec3 v = uvec3(cell) * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  return float(v.x >> 8u) / 16777216.0;
}

// value noise, 0 to 1, with a mean of 0.5
float farol_fogNoise(const in vec3 place) {
  ivec3 cell = ivec3(floor(place));
  vec3 f = place - vec3(cell);
  f = f * f * (3.0 - 2.0 * f);
  vec4 low = vec4(farol_fogHash(cell), farol_fogHash(cell + ivec3(1, 0, 0)), farol_fogHash(cell + ivec3(0, 1, 0)),
    farol_fogHash(cell + ivec3(1, 1, 0)));
  vec4 high = vec4(farol_fogHash(cell + ivec3(0, 0, 1)), farol_fogHash(cell + ivec3(1, 0, 1)),
    farol_fogHash(cell + ivec3(0, 1, 1)), farol_fogHash(cell + ivec3(1, 1, 1)));
  vec4 z = mix(low, high, f.z);
  vec2 y = mix(z.xy, z.zw, f.y);
  return mix(y.x, y.y, f.x);
}

// rgb: scattering coefficient (1/m); a: extinction coefficient (1/m)
vec4 farol_mediumAt(const in vec3 positionWS) {
  vec4 medium = farol_fogScatter;
  if (farol_fogHeight.y > 0.0) medium *= exp(-max(0.0, positionWS.y - farol_fogHeight.x) * farol_fogHeight.y);
  if (farol_fogHeight.z > 0.0) {
    vec3 place = (positionWS - farol_fogDrift) * farol_fogHeight.w;
    float noise = (2.0 * farol_fogNoise(place) + farol_fogNoise(place * 2.0 + 17.0)) / 3.0;
    medium *= max(0.0, 1.0 + farol_fogHeight.z * (4.0 * noise - 2.0));
  }
  for (int i = 0; i < farol_fogVolumes; i++) {
    vec3 at = abs((farol_fogVolumeInverse[i] * vec4(positionWS, 1.0)).xyz) * 2.0;
    float away = farol_fogVolumeShape[i].x > 0.0 ? length(at) : max(at.x, max(at.y, at.z));
    medium += farol_fogVolumeScatter[i] * clamp((1.0 - away) * farol_fogVolumeShape[i].y, 0.0, 1.0);
  }
  return max(medium, vec4(0.0));
}
