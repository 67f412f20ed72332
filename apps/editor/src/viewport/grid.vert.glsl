// A large plane at the height 0 of the world, round the camera.
uniform float extent;
varying vec3 vPosition;

void main() {
  vPosition = vec3(position.x * extent + floor(cameraPosition.x), 0.0, position.z * extent + floor(cameraPosition.z));
  gl_Position = projectionMatrix * viewMatrix * vec4(vPosition, 1.0);
}
