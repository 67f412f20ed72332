// False colours of illuminance, one colour per decade, from 0.1 lx up; black where no light falls.
// Farol
precision highp float;

uniform sampler2D picture; // linear luminance (cd/m²) of the scene in white, which reflects all light evenly
uniform vec3 stops[ 7 ]; // sRGB colours at 0.1, 1, 10, … lx
out vec4 farol_color;

void main() {
  vec3 light = texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb;
  float illuminance = 3.14159265 * dot(light, vec3(0.2126, 0.7152, 0.0722));
  float decade = clamp(log2(max(illuminance, 1e-9)) / log2(10.0) + 1.0, 0.0, 6.0);
  int at = min(int(decade), 5);
  vec3 colour = mix(stops[at], stops[at + 1], decade - float(at));
  farol_color = vec4(illuminance > 0.0 ? colour : vec3(0.03), 1.0);
}
