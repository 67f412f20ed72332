// A large plane around the view's centre: the ground, or in axis-aligned views the plane facing the camera.
uniform float extent;
uniform vec3 middle;
uniform vec3 axisU;
uniform vec3 axisV;
uniform float behind;
varying vec3 vPosition;

void main() {
  vec3 origin = axisU * floor(dot(middle, axisU)) + axisV * floor(dot(middle, axisV));
  vPosition = origin + extent * (position.x * axisU + position.z * axisV);
  gl_Position = projectionMatrix * viewMatrix * vec4(vPosition, 1.0);
  // the grid is drawn at the far plane, behind everything
  gl_Position.z = mix(gl_Position.z, 0.99999 * gl_Position.w, behind);
}
