// World positions and normals of a lightmap's texels
// three.js
in vec3 farol_position;
in vec3 farol_normal;
flat in vec3 farol_face;
layout(location = 0) out highp vec4 farol_place;
layout(location = 1) out highp vec4 farol_texelNormal;
layout(location = 2) out highp vec4 farol_texelFace;

void main() {
  farol_place = vec4(farol_position, 1.0);
  farol_texelNormal = vec4(normalize(farol_normal), 1.0);
  farol_texelFace = vec4(normalize(farol_face), 1.0);
}
