// Depth for temporal anti-aliasing: distances of samples (m along the view), and their motion since the last frame.
// Karis 2014, High Quality Temporal Supersampling
#include "frameSize"
#include "storedDistance"
uniform highp sampler2D farol_pictureDepth;
// distances of surfaces, where depth cannot give them (polygonOffset, oblique near plane, few bits), and the depth
// drawn with them
uniform highp sampler2D farol_distances;
uniform highp sampler2D farol_distanceDepth;
uniform highp int farol_distancesStored; // kind of stored distances: 0 none, 1 perspective, 2 orthographic
// xy: motion (in picture widths, heights); z: change of distance (m); w: 1 where objects move
uniform highp sampler2D farol_motionMap;
uniform highp mat4 farol_reproject; // transform of this frame's normalised device coordinates to last frame's
uniform highp vec2 farol_jitter; // this frame's subpixel offset of the projection (normalised device coordinates)
uniform highp vec2 farol_depthKind; // x: 1 if depth is reversed, else 0; y: log2(far + 1) if it is logarithmic, else 0
uniform highp vec4 farol_projectZ; // for a view-space z of v: clip z = x v + y, clip w = z v + w
uniform bool farol_hasMotion; // whether the motion map holds any motion

ivec2 farol_inPicture(const in ivec2 pixel) {
  return clamp(pixel, ivec2(0), ivec2(farol_frameSize) - 1);
}

// normalised device z of a depth-buffer value; reversed depth is that z, logarithmic depth first gives view-space z
float farol_deviceZ(const in float depth) {
  if (farol_depthKind.y > 0.0) {
    float z = 1.0 - exp2(depth * farol_depthKind.y);
    return (farol_projectZ.x * z + farol_projectZ.y) / max(farol_projectZ.z * z + farol_projectZ.w, 1e-6);
  }
  return farol_depthKind.x > 0.5 ? depth : depth * 2.0 - 1.0;
}

// stored distance of a pixel's surface (m); 0 when none is stored
float farol_storedAt(const in ivec2 pixel, const in float depth) {
  if (farol_distancesStored == 0 || abs(texelFetch(farol_distanceDepth, pixel, 0).r - depth) > 1e-5) return 0.0;
  float away = farol_unpackDistance(texelFetch(farol_distances, pixel, 0).rg, farol_distancesStored == 2);
  return away < 5.9e4 ? max(away, 1e-3) : 0.0;
}

float farol_deviceZAt(const in float away) {
  return (farol_projectZ.y - away * farol_projectZ.x) / (farol_projectZ.w - away * farol_projectZ.z);
}

// a surface's distance along the view (m) for normalised device z; at most 6e4, so that half floats hold it
float farol_distanceOf(const in float deviceZ) {
  float z = (farol_projectZ.y - deviceZ * farol_projectZ.w) / (deviceZ * farol_projectZ.z - farol_projectZ.x);
  return clamp(-z, 1e-3, 6e4);
}

float farol_distanceAt(const in ivec2 pixel) {
  ivec2 inside = farol_inPicture(pixel);
  float depth = texelFetch(farol_pictureDepth, inside, 0).r;
  float stored = farol_storedAt(inside, depth);
  if (stored > 0.0) return stored;
  if (farol_depthKind.y > 0.0) return clamp(exp2(depth * farol_depthKind.y) - 1.0, 1e-3, 6e4);
  return farol_distanceOf(farol_deviceZ(depth));
}

// xy: motion of a sample's surface since the last frame (in picture widths, heights); z: its distance then (m)
vec3 farol_wayOf(const in ivec2 pixel, const in float away) {
  if (farol_hasMotion) {
    vec4 motion = texelFetch(farol_motionMap, pixel, 0);
    if (motion.w > 0.5) return vec3(motion.xy, max(away + motion.z, 1e-3));
  }
  vec2 now = (vec2(pixel) + 0.5) / farol_frameSize * 2.0 - 1.0 - farol_jitter;
  float depth = texelFetch(farol_pictureDepth, pixel, 0).r;
  float stored = farol_storedAt(pixel, depth);
  vec4 before = farol_reproject * vec4(now, stored > 0.0 ? farol_deviceZAt(stored) : farol_deviceZ(depth), 1.0);
  return vec3(0.5 * (now - before.xy / before.w), farol_distanceOf(before.z / before.w));
}

// motion (in picture widths, heights) of a still point at uv and distance (m), due to the camera
vec2 farol_wayAt(const in vec2 place, const in float away) {
  vec2 now = place * 2.0 - 1.0;
  vec4 before = farol_reproject * vec4(now, farol_deviceZAt(away), 1.0);
  return 0.5 * (now - before.xy / before.w);
}
