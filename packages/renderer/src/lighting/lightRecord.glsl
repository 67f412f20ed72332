// Reads the records of the light table.
// Farol; made from the tables in lights/lightRecord.ts by lighting/recordGetters.test.ts
uniform highp sampler2D farol_lightTable;
vec4 farol_lightTexel(const in int record, const in int texel) {
  ivec2 at = ivec2((record & 255) * 4 + texel, record >> 8);
  return texelFetch(farol_lightTable, at, 0);
}
#ifdef FAROL_FEW_LIGHTS
vec4 farol_sphereTexel(const in int record) {
  if (record >= farol_fewLights) return farol_lightTexel(record, 0);
  return farol_few(farol_fewSphere0, farol_fewSphere1, record);
}
vec4 farol_emissionTexel(const in int record) {
  if (record >= farol_fewLights) return farol_lightTexel(record, 1);
  return farol_few(farol_fewEmission0, farol_fewEmission1, record);
}
#else
#define farol_sphereTexel(record) farol_lightTexel(record, 0)
#define farol_emissionTexel(record) farol_lightTexel(record, 1)
#endif
vec4 farol_lightSphere(int record) { return farol_sphereTexel(record); }
vec3 farol_lightDirection(int record) { return farol_sphereTexel(record).xyz; }
vec3 farol_lightPosition(vec4 t) { return t.xyz; }
float farol_lightRange(vec4 t) { return t.w; }
vec4 farol_lightEmission(int record) { return farol_emissionTexel(record); }
vec3 farol_lightColor(vec4 t) { return t.rgb; }
bool farol_lightIsPlain(vec4 t) { return t.w >= 0.0; }
bool farol_lightIsPlain(int record) { return farol_emissionTexel(record).w >= 0.0; }
float farol_lightPlainDecay(vec4 t) { return t.w; }
float farol_lightOtherDecay(vec4 t) { return -64.0 - t.w; }
float farol_lightDecay(vec4 t) { return t.w >= 0.0 ? t.w : -64.0 - t.w; }
bool farol_lightHasDetails(vec4 t) { return t.w != 0.0; }
vec4 farol_lightCone(int record) { return farol_lightTexel(record, 2); }
vec3 farol_lightAxis(vec4 t) { return t.xyz; }
float farol_lightCutoff(vec4 t) { return t.w; }
bool farol_lightIsCone(vec4 t) { return t.w > -1.0; }
vec4 farol_lightDetails(int record) { return farol_lightTexel(record, 3); }
float farol_lightPenumbra(vec4 t) { return t.x; }
float farol_lightExponent(vec4 t) { return t.y; }
int farol_lightMaskRecord(vec4 t) { return int(t.z); }
int farol_lightExtensionRecord(vec4 t) { return int(t.w); }
bool farol_lightIsSpot(vec4 t) { return t.x >= -1.0; }
bool farol_lightIsMasked(vec4 t) { return t.z > 0.0; }
bool farol_lightIsMaskedPoint(vec4 t) { return t.x < -1.0 && t.w == 0.0; }
bool farol_lightIsArea(vec4 t) { return t.x < -2.5; }
vec3 farol_extensionDiffuse(int record) { return farol_lightTexel(record, 0).rgb; }
vec3 farol_extensionSpecular(int record) { return farol_lightTexel(record, 1).rgb; }
vec3 farol_extensionAmbient(int record) { return farol_lightTexel(record, 2).rgb; }
vec4 farol_extensionFalloff(int record) { return farol_lightTexel(record, 3); }
float farol_extensionNear(vec4 t) { return t.x; }
float farol_extensionFar(vec4 t) { return t.y; }
vec3 farol_extensionFactors(vec4 t) { return t.xyz; }
bool farol_extensionIsNearFar(vec4 t) { return t.w == 1.0; }
bool farol_extensionIsPolynomial(vec4 t) { return t.w == 2.0; }
