// Head of vertex shaders that draw both eyes at once: clip space is the eye's, view space the union camera's.
// OVR_multiview2: https://registry.khronos.org/webgl/extensions/OVR_multiview2/
layout(num_views = 2) in;
uniform mat4 farol_eyeProjections[2]; // from view space of the union camera to an eye's clip space
uniform vec3 farol_eyesWS[2];
#define projectionMatrix farol_eyeProjections[gl_ViewID_OVR]
#define cameraPosition farol_eyesWS[gl_ViewID_OVR]
