// Places an icon of the atlas at a world position, with a constant size in pixels.
attribute float kind;
attribute vec3 tint;
attribute float selected;
uniform float size;
varying vec3 vTint;
varying float vKind;
varying float vSelected;

void main() {
  vTint = tint;
  vKind = kind;
  vSelected = selected;
  vec4 positionVS = modelViewMatrix * vec4(position, 1.0);
  // the icon is moved 0.3 m towards the camera, so that the mesh of a lamp does not hide it
  if (isOrthographic) positionVS.z += 0.3;
  else positionVS.xyz *= max(0.5, 1.0 - 0.3 / length(positionVS.xyz));
  gl_Position = projectionMatrix * positionVS;
  gl_PointSize = size * (selected > 0.5 ? 1.25 : 1.0);
}
