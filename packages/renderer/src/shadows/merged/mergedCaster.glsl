// Corners of many objects' triangles, where their objects are.
// Farol
uniform mat4 modelViewMatrix; // from the origin that they count from
uniform mat4 projectionMatrix;
in vec3 position; // m
//# main
gl_Position = projectionMatrix * (modelViewMatrix * vec4(position, 1.0));
