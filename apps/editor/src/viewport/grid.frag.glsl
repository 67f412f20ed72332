// Grid lines at the spacing `step` and at ten times that, one pixel wide, fading with distance; the axes are coloured.
uniform float extent;
uniform float step;
uniform vec3 middle;
uniform vec3 axisU;
uniform vec3 axisV;
varying vec3 vPosition;

float farol_editorGridLine(vec2 cell) {
  vec2 width = fwidth(cell);
  vec2 line = abs(fract(cell - 0.5) - 0.5) / width;
  // lines closer together than a pixel fade out instead of aliasing
  return (1.0 - min(min(line.x, line.y), 1.0)) * (1.0 - smoothstep(0.2, 0.6, max(width.x, width.y)));
}

void main() {
  vec2 place = vec2(dot(vPosition, axisU), dot(vPosition, axisV));
  vec2 cell = place / step;
  float strength = max(0.10 * farol_editorGridLine(cell), 0.22 * farol_editorGridLine(cell / 10.0));
  vec2 axis = 1.0 - min(abs(place) / fwidth(place), vec2(1.0));
  vec3 colour = vec3(0.55);
  // red along x, green along y, blue along z
  mat3 colours = mat3(vec3(0.8, 0.12, 0.1), vec3(0.15, 0.55, 0.1), vec3(0.1, 0.25, 0.85));
  if (axis.y > 0.0) colour = colours * axisU;
  if (axis.x > 0.0) colour = colours * axisV;
  strength = max(strength, 0.45 * max(axis.x, axis.y));
  strength *= 1.0 - smoothstep(0.3, 1.0, distance(vPosition, middle) / extent);
  if (strength < 0.004) discard;
  gl_FragColor = vec4(colour, strength);
  #include <colorspace_fragment>
}
