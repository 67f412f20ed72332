// The box of a decal, its inside: drawn once a pixel also with the camera in it.
// Farol
in vec3 position;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
//# main
gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
