// View-space position (m) of a pixel from its window depth and the inverse projection, perspective and orthographic.
// Thesis 2.2.3.1.2
//? farol_positionFromDepth(vec2(0.5, 1.0), 0.0, mat4(1.0)) == vec3(0.0, 1.0, -1.0)
//? farol_positionFromDepth(vec2(0.5), 1.0, inverse(mat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2, -1, 0, 0, -3, 0))) == vec3(0.0, 0.0, -3.0)
//? farol_positionFromDepth(vec2(1.0, 0.0), 0.5, inverse(mat4(1, 0, 0, 0, 0, 2, 0, 0, 0, 0, -2, -1, 0, 0, -3, 0))) == vec3(1.5, -0.75, -1.5)
vec3 farol_positionFromDepth(const in vec2 uv, const in float depth, const in mat4 projectionInverse) {
  vec4 positionVS = projectionInverse * vec4(vec3(uv, depth) * 2.0 - 1.0, 1.0);
  return positionVS.xyz / positionVS.w;
}
