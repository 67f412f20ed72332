// Outline of a mask: share of covered texels in a ring around each pixel, only where the mask itself is empty.
uniform sampler2D mask;
uniform vec2 texel;
uniform float radius;
uniform vec3 colour;
varying vec2 vUv;

void main() {
  float inside = texture2D(mask, vUv).r;
  float near = 0.0;
  for (int i = 0; i < 12; i++) {
    float angle = 6.2831853 * float(i) / 12.0;
    near = max(near, texture2D(mask, vUv + radius * texel * vec2(cos(angle), sin(angle))).r);
  }
  gl_FragColor = vec4(colour, near * (1.0 - inside));
}
