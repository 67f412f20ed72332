// What the picture is multiplied by: 1 in the middle, less towards the corners.
// Farol
precision highp float;
uniform vec2 size;
out vec4 color;
void main() {
  vec2 fromMiddle = gl_FragCoord.xy / size - 0.5;
  color = vec4(vec3(1.0 - 1.6 * dot(fromMiddle, fromMiddle)), 1.0);
}
