// Head of fragment shaders that draw both eyes at once; tiles of light lists are the union camera's.
// Farol
uniform highp vec3 farol_eyesWS[2];
uniform highp vec3 farol_eyesVS[2]; // view space of the union camera
uniform highp vec4 farol_unionPixels; // pixel of a point: xy * (x, y) / depth + zw
uniform highp vec2 farol_unionLast; // last pixel of the union camera's picture
uniform highp vec2 farol_eyeOrigins[2]; // first pixel of an eye in the session's layer
#define cameraPosition farol_eyesWS[gl_ViewID_OVR]

vec2 farol_unionPixel(const in vec3 positionVS) {
  vec2 pixel = farol_unionPixels.xy * positionVS.xy / -positionVS.z + farol_unionPixels.zw;
  return clamp(pixel, vec2(0.0), farol_unionLast);
}
