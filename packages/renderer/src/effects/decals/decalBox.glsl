// Inner faces of a decal's box, so that each pixel is drawn once even with the camera in the box.
// Farol
in vec3 position;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
//# main
gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
