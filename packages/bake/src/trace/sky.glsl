// Radiance from outside the scene
// three.js, hemilight_fragment and equirectUv
uniform vec3 farol_skyColour;
uniform vec3 farol_skyUp[SKY_LIGHTS];
uniform vec3 farol_skyAbove[SKY_LIGHTS]; // radiance of the upper half, for each sky light
uniform vec3 farol_skyBelow[SKY_LIGHTS];
#ifdef SKY_TEXTURE
uniform sampler2D farol_skyMap;
uniform mat3 farol_skyTurn;
uniform float farol_skyFactor;
#endif

vec3 farol_sky(const in vec3 direction) {
  vec3 radiance = farol_skyColour;
  for (int i = 0; i < SKY_LIGHTS; i++) {
    radiance += dot(direction, farol_skyUp[i]) > 0.0 ? farol_skyAbove[i] : farol_skyBelow[i];
  }
#ifdef SKY_TEXTURE
  vec3 turned = farol_skyTurn * direction;
  vec2 uv = vec2(atan(turned.z, turned.x) * 0.15915494 + 0.5, asin(clamp(turned.y, -1.0, 1.0)) * 0.31830989 + 0.5);
  radiance += textureLod(farol_skyMap, uv, 0.0).rgb * farol_skyFactor;
#endif
  return radiance;
}
