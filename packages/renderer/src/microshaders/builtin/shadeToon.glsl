// three's toon shading in a loop that may differ from pixel to pixel, where derivatives mean nothing: takes them before it.
// three.js r187's gradientmap_pars_fragment; derivatives: OpenGL ES Shading Language 3.00, 8.9
#include "incidentLight"
#define FAROL_TOON
vec3 farol_toonNormals[3]; // of the pixels whose differences dFdx and dFdy are: one, that beside it, that above it
vec3 farol_toonSteps[3]; // to their positions, from this one's

void farol_startToon(const in vec3 positionVS, const in vec3 normalVS) {
  vec3 normalX = dFdx(normalVS), normalY = dFdy(normalVS), stepX = dFdx(positionVS), stepY = dFdy(positionVS);
  vec2 odd = mod(floor(gl_FragCoord.xy), 2.0);
  float corner = odd == vec2(0.0) ? 1.0 : 0.0;
  float cornerX = dFdx(corner), cornerY = dFdy(corner);
  vec3 cornerNormal = dFdx(corner * normalVS) / cornerX, cornerPosition = dFdx(corner * positionVS) / cornerX;
  if (cornerX != 0.0 && cornerY != 0.0) { // a device that takes one difference for all four pixels, from their corner
    farol_toonNormals = vec3[3](cornerNormal, cornerNormal + normalX, cornerNormal + normalY);
    vec3 base = cornerPosition - positionVS;
    farol_toonSteps = vec3[3](base, base + stepX, base + stepY);
  } else { // from this pixel, which may be the one at the right or above
    vec2 side = (1.0 - 2.0 * odd) * vec2(dFdx(odd.x), dFdy(odd.y));
    farol_toonNormals = vec3[3](normalVS, normalVS + side.x * normalX, normalVS + side.y * normalY);
    farol_toonSteps = vec3[3](vec3(0.0), side.x * stepX, side.y * stepY);
  }
}

float farol_toonCoord(const in FarolLight light, const in int pixel) {
  vec3 toLight = light.direction;
  if (light.distance > 0.0) toLight = normalize(toLight * light.distance - farol_toonSteps[pixel]);
  return dot(farol_toonNormals[pixel], toLight) * 0.5 + 0.5;
}

vec3 farol_toonGradient(const in FarolLight light, const in vec3 normalVS) {
  float coord = dot(normalVS, light.direction) * 0.5 + 0.5;
  float base = farol_toonCoord(light, 0);
  vec2 slope = vec2(farol_toonCoord(light, 1), farol_toonCoord(light, 2)) - base;
  #ifdef USE_GRADIENTMAP
    return vec3(textureGrad(gradientMap, vec2(coord, 0.0), vec2(slope.x, 0.0), vec2(slope.y, 0.0)).r);
  #else
    float width = (abs(slope.x) + abs(slope.y)) * 0.5;
    return mix(vec3(0.7), vec3(1.0), smoothstep(0.7 - width, 0.7 + width, coord));
  #endif
}
