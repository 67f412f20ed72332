// Transforms a field's lights to view space, a texel each; lights without effect or out of view get range 0.
// Farol
uniform highp sampler2D farol_fieldSpheres;
uniform highp sampler2D farol_fieldEmissions;
uniform highp sampler2D farol_fieldCones;
// x: number of lights; y: first row of the target; z: lights in a row of the textures; w: 1 with farol_fieldCones
uniform highp ivec4 farol_fieldRun;
uniform highp mat4 farol_fieldMatrix; // transform from the field's space to view space
uniform highp vec3 farol_fieldColor;
uniform highp vec4 farol_fieldPlanes[6]; // planes of the view frustum (view space), normals inward
uniform highp mat4 farol_fieldProjection;
uniform highp vec3 farol_fieldDepths; // x: where the first cell begins (m, or log2 of m); y: cells a unit; z: 1 if log2
layout(location = 0) out highp vec4 farol_fieldSphere;
// rgb: linear colour times intensity (cd); a: decay, coded as in lights/lightRecord.ts
layout(location = 1) out highp vec4 farol_fieldEmission;
// xyz: axis towards the light, with length 2 + cosine where the penumbra begins; w: cosine of the cutoff; 0: point
// light
layout(location = 2) out highp vec4 farol_fieldCone;
layout(location = 3) out highp vec4 farol_fieldCell;

// whether all components are within ± limit; false for NaN
bool farol_isWithin(const in vec3 v, const in float limit) {
  return abs(v.x) <= limit && abs(v.y) <= limit && abs(v.z) <= limit;
}

// cell of a light: 8 × 4 parts of the picture by 4 of depth, 128 in all
float farol_cellOf(const in vec3 positionVS) {
  vec4 clip = farol_fieldProjection * vec4(positionVS, 1.0);
  vec2 at = (clip.xy / max(clip.w, 1e-6) * 0.5 + 0.5) * vec2(8.0, 4.0);
  float depth = farol_fieldDepths.z > 0.0 ? log2(max(-positionVS.z, 1e-6)) : -positionVS.z;
  float slice = floor(clamp((depth - farol_fieldDepths.x) * farol_fieldDepths.y, 0.0, 3.0));
  return (slice * 4.0 + floor(clamp(at.y, 0.0, 3.0))) * 8.0 + floor(clamp(at.x, 0.0, 7.0));
}
//# main
ivec2 texel = ivec2(gl_FragCoord.xy);
int light = ((texel.y - farol_fieldRun.y) << 7) + texel.x;
// a light without effect is placed far from everything
farol_fieldSphere = vec4(1e15, 0.0, 0.0, 1.0);
farol_fieldEmission = vec4(0.0, 0.0, 0.0, 2.0);
farol_fieldCone = vec4(0.0);
farol_fieldCell = vec4(128.0);
if (light < farol_fieldRun.x) {
  ivec2 at = ivec2(light % farol_fieldRun.z, light / farol_fieldRun.z);
  vec4 sphere = texelFetch(farol_fieldSpheres, at, 0);
  vec4 emission = texelFetch(farol_fieldEmissions, at, 0);
  vec3 color = emission.rgb * farol_fieldColor;
  bool lit = farol_isWithin(sphere.xyz, 1e14) && sphere.w > 0.0 && sphere.w <= 1e14 && farol_isWithin(color, 1e30)
    && color != vec3(0.0) && emission.a >= 0.0 && emission.a <= 1e3;
  vec4 cone = vec4(0.0);
  if (farol_fieldRun.w > 0) {
    cone = texelFetch(farol_fieldCones, at, 0);
    if (!(farol_isWithin(cone.xyz, 4.0) && abs(cone.w) <= 1.0)) lit = false;
    else if (cone.xyz != vec3(0.0))
      cone.xyz = -normalize(mat3(farol_fieldMatrix) * cone.xyz) * clamp(length(cone.xyz), 1.0, 3.0);
  }
  if (lit) {
    sphere.xyz = (farol_fieldMatrix * vec4(sphere.xyz, 1.0)).xyz;
    for (int i = 0; i < 6; i++) {
      if (dot(farol_fieldPlanes[i], vec4(sphere.xyz, 1.0)) < -sphere.w) lit = false;
    }
  }
  if (lit && farol_isWithin(sphere.xyz, 1e14)) {
    farol_fieldSphere = sphere;
    farol_fieldEmission = vec4(color, cone.xyz != vec3(0.0) ? -64.0 - emission.a : emission.a);
    farol_fieldCone = cone;
    farol_fieldCell = vec4(farol_cellOf(sphere.xyz));
  }
}
