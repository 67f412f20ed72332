// Depth for temporal anti-aliasing: distances of samples (m along the view), and their ways since the last frame.
// Karis 2014, High Quality Temporal Supersampling
uniform highp sampler2D farol_pictureDepth;
// x, y: way in pictures; z: change of distance (m); w: 1 where something moves by itself
uniform highp sampler2D farol_motionMap;
uniform highp mat4 farol_reproject; // transform of this frame's normalised device coordinates to last frame's
uniform highp vec2 farol_jitter; // normalised device coordinates
uniform highp vec2 farol_depthKind; // 1 if depth is reversed; log2(far + 1) if it is logarithmic, else 0
uniform highp vec4 farol_projectZ; // of a view z: factor and sum of clip z, factor and sum of clip w
uniform bool farol_hasMotion; // whether the motion map holds any motion

ivec2 farol_inPicture(const in ivec2 pixel) {
  return clamp(pixel, ivec2(0), textureSize(farol_pictureDepth, 0) - 1);
}

// normalised device z from a stored depth: three's reversed depth is that itself, its logarithmic one comes from clip w
float farol_deviceZ(const in float depth) {
  if (farol_depthKind.y > 0.0) {
    float z = 1.0 - exp2(depth * farol_depthKind.y);
    return (farol_projectZ.x * z + farol_projectZ.y) / max(farol_projectZ.z * z + farol_projectZ.w, 1e-6);
  }
  return farol_depthKind.x > 0.5 ? depth : depth * 2.0 - 1.0;
}

// limited to the range of half floats
float farol_distanceOf(const in float deviceZ) {
  float z = (farol_projectZ.y - deviceZ * farol_projectZ.w) / (deviceZ * farol_projectZ.z - farol_projectZ.x);
  return clamp(-z, 1e-3, 6e4);
}

float farol_distanceAt(const in ivec2 pixel) {
  float depth = texelFetch(farol_pictureDepth, farol_inPicture(pixel), 0).r;
  if (farol_depthKind.y > 0.0) return clamp(exp2(depth * farol_depthKind.y) - 1.0, 1e-3, 6e4);
  return farol_distanceOf(farol_deviceZ(depth));
}

// how far what a sample shows has come since the last frame (pictures), and its distance then (m)
vec3 farol_wayOf(const in ivec2 pixel, const in float away) {
  if (farol_hasMotion) {
    vec4 motion = texelFetch(farol_motionMap, pixel, 0);
    if (motion.w > 0.5) return vec3(motion.xy, max(away + motion.z, 1e-3));
  }
  vec2 now = (vec2(pixel) + 0.5) / vec2(textureSize(farol_pictureDepth, 0)) * 2.0 - 1.0 - farol_jitter;
  vec4 before = farol_reproject * vec4(now, farol_deviceZ(texelFetch(farol_pictureDepth, pixel, 0).r), 1.0);
  return vec3(0.5 * (now - before.xy / before.w), farol_distanceOf(before.z / before.w));
}

// how far what stands still would have come at a place (pictures) and distance (m)
vec2 farol_wayAt(const in vec2 place, const in float away) {
  float deviceZ = (farol_projectZ.y - away * farol_projectZ.x) / (farol_projectZ.w - away * farol_projectZ.z);
  vec2 now = place * 2.0 - 1.0;
  vec4 before = farol_reproject * vec4(now, deviceZ, 1.0);
  return 0.5 * (now - before.xy / before.w);
}
