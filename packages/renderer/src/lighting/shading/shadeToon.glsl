// three's toon shading in a light loop that may differ from pixel to pixel: derivatives are computed before the loop.
// three.js r187's gradientmap_pars_fragment; derivatives: OpenGL ES Shading Language 3.00, 8.9
#include "incidentLight"
#define FAROL_TOON
// normals of the four pixels that dFdx (left, right) and dFdy (below, above) subtract
vec3 farol_toonNormals[4];
vec3 farol_toonSteps[4]; // offsets from this pixel's position to those of the four pixels (m)

void farol_startToon(const in vec3 positionVS, const in vec3 normalVS) {
  // second, first: 1 in the second, first column or row of the quad, else 0: the derivative of a product with one of
  // them is, up to sign, the value at that pixel, on any device
  vec2 second = mod(floor(gl_FragCoord.xy), 2.0), first = 1.0 - second;
  float signX = dFdx(second.x), signY = dFdy(second.y);
  farol_toonNormals = vec3[4](
    -signX * dFdx(first.x * normalVS), signX * dFdx(second.x * normalVS),
    -signY * dFdy(first.y * normalVS), signY * dFdy(second.y * normalVS)
  );
  farol_toonSteps = vec3[4](
    -signX * dFdx(first.x * positionVS) - positionVS, signX * dFdx(second.x * positionVS) - positionVS,
    -signY * dFdy(first.y * positionVS) - positionVS, signY * dFdy(second.y * positionVS) - positionVS
  );
}

float farol_toonCoord(const in FarolLight light, const in int pixel) {
  vec3 toLight = light.direction;
  if (light.distance > 0.0) toLight = normalize(toLight * light.distance - farol_toonSteps[pixel]);
  return dot(farol_toonNormals[pixel], toLight) * 0.5 + 0.5;
}

vec3 farol_toonGradient(const in FarolLight light, const in vec3 normalVS) {
  float coord = dot(normalVS, light.direction) * 0.5 + 0.5;
  float slopeX = farol_toonCoord(light, 1) - farol_toonCoord(light, 0);
  float slopeY = farol_toonCoord(light, 3) - farol_toonCoord(light, 2);
  #ifdef USE_GRADIENTMAP
    return vec3(textureGrad(gradientMap, vec2(coord, 0.0), vec2(slopeX, 0.0), vec2(slopeY, 0.0)).r);
  #else
    float width = (abs(slopeX) + abs(slopeY)) * 0.5;
    return mix(vec3(0.7), vec3(1.0), smoothstep(0.7 - width, 0.7 + width, coord));
  #endif
}
