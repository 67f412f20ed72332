// Temporal anti-aliasing: the picture of this frame, mixed with what the frames before it showed of the same surface.
// Karis 2014, High Quality Temporal Supersampling; Salvi 2016, An Excursion in Temporal Supersampling (variance clipping)
#include "displayTransfer"
uniform highp sampler2D farol_picture;
uniform highp sampler2D farol_pictureDepth;
uniform highp sampler2D farol_history;
uniform highp sampler2D farol_motionMap;
uniform highp mat4 farol_reproject; // this frame's normalised device coordinates to last frame's
uniform highp vec2 farol_jitter; // normalised device coordinates
uniform highp vec2 farol_depthKind; // 1 if depth is reversed; log2(far + 1) if it is logarithmic, else 0
uniform highp vec4 farol_projectZ; // of a view z: factor and sum of clip z, factor and sum of clip w
uniform bool farol_encoded;
uniform bool farol_hasMotion; // the motion map holds something
uniform highp vec2 farol_share; // of the new frame: in a pixel that moves, and in one that does not; 1: there is no history
uniform float farol_gamma; // standard deviations to which the history is clipped; 0: it is not
layout(location = 0) out highp vec4 farol_color;

vec4 farol_pictureAt(const in ivec2 pixel) {
  vec4 color = texelFetch(farol_picture, clamp(pixel, ivec2(0), textureSize(farol_picture, 0) - 1), 0);
  if (farol_encoded) color.rgb = farol_toLinear(color.rgb);
  return color;
}

vec3 farol_toYCoCg(const in vec3 c) {
  return vec3(0.25 * (c.r + c.b) + 0.5 * c.g, 0.5 * (c.r - c.b), 0.5 * c.g - 0.25 * (c.r + c.b));
}

vec3 farol_fromYCoCg(const in vec3 c) {
  float t = c.x - c.z;
  return vec3(t + c.y, c.x + c.z, t - c.y);
}

// Catmull-Rom by nine bilinear reads' worth in five, without the corners: Jimenez 2016, Filmic SMAA
vec4 farol_sharpHistory(const in vec2 uv, const in vec2 size) {
  vec2 place = uv * size;
  vec2 centre = floor(place - 0.5) + 0.5;
  vec2 f = place - centre;
  vec2 w0 = f * (-0.5 + f * (1.0 - 0.5 * f));
  vec2 w1 = 1.0 + f * f * (-2.5 + 1.5 * f);
  vec2 w2 = f * (0.5 + f * (2.0 - 1.5 * f));
  vec2 w3 = f * f * (-0.5 + 0.5 * f);
  vec2 w12 = w1 + w2;
  vec2 t12 = (centre + w2 / w12) / size;
  vec2 t0 = (centre - 1.0) / size;
  vec2 t3 = (centre + 2.0) / size;
  vec4 sum = texture(farol_history, vec2(t12.x, t0.y)) * w12.x * w0.y;
  sum += texture(farol_history, vec2(t0.x, t12.y)) * w0.x * w12.y;
  sum += texture(farol_history, t12) * w12.x * w12.y;
  sum += texture(farol_history, vec2(t3.x, t12.y)) * w3.x * w12.y;
  sum += texture(farol_history, vec2(t12.x, t3.y)) * w12.x * w3.y;
  float total = w12.x * w0.y + w0.x * w12.y + w12.x * w12.y + w3.x * w12.y + w12.x * w3.y;
  return max(sum / total, 0.0);
}

// normalised device z from a stored depth: three's reversed depth is that itself, its logarithmic one comes from clip w
float farol_deviceZ(const in float depth) {
  if (farol_depthKind.y > 0.0) {
    float z = 1.0 - exp2(depth * farol_depthKind.y);
    return (farol_projectZ.x * z + farol_projectZ.y) / max(farol_projectZ.z * z + farol_projectZ.w, 1e-6);
  }
  return farol_depthKind.x > 0.5 ? depth : depth * 2.0 - 1.0;
}

// how far what the pixel shows has moved since the last frame, in pictures
vec2 farol_velocity(const in ivec2 pixel, const in vec2 size) {
  ivec2 nearest = pixel;
  float depth = farol_depthKind.x > 0.5 ? 0.0 : 1.0;
  for (int y = -1; y <= 1; y++) for (int x = -1; x <= 1; x++) {
    ivec2 at = clamp(pixel + ivec2(x, y), ivec2(0), ivec2(size) - 1);
    float there = texelFetch(farol_pictureDepth, at, 0).r;
    if (farol_depthKind.x > 0.5 ? there > depth : there < depth) { depth = there; nearest = at; }
  }
  if (farol_hasMotion) {
    vec4 motion = texelFetch(farol_motionMap, nearest, 0);
    if (motion.a > 0.5) return motion.xy;
  }
  vec2 now = (vec2(nearest) + 0.5) / size * 2.0 - 1.0 - farol_jitter;
  vec4 before = farol_reproject * vec4(now, farol_deviceZ(depth), 1.0);
  return 0.5 * (now - before.xy / before.w);
}
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy);
vec2 size = vec2(textureSize(farol_picture, 0));
farol_color = farol_pictureAt(pixel);
if (farol_share.x < 1.0) {
  vec2 velocity = farol_velocity(pixel, size);
  vec2 uv = gl_FragCoord.xy / size - velocity;
  bool still = all(lessThan(abs(velocity * size), vec2(1e-3)));
  if (uv == clamp(uv, 0.0, 1.0)) {
    vec4 history = still ? texelFetch(farol_history, pixel, 0) : farol_sharpHistory(uv, size);
    if (farol_gamma > 0.0) {
      vec3 sum = vec3(0.0);
      vec3 squares = vec3(0.0);
      for (int y = -1; y <= 1; y++) for (int x = -1; x <= 1; x++) {
        vec3 c = farol_toYCoCg(farol_pictureAt(pixel + ivec2(x, y)).rgb);
        sum += c;
        squares += c * c;
      }
      vec3 mean = sum / 9.0;
      vec3 reach = farol_gamma * sqrt(max(squares / 9.0 - mean * mean, 0.0));
      vec3 off = farol_toYCoCg(history.rgb) - mean;
      vec3 ratio = abs(off) / max(reach, 1e-5);
      vec3 believed = farol_fromYCoCg(mean + off / max(max(ratio.x, max(ratio.y, ratio.z)), 1.0));
      // what is thinner than a pixel is missed by some frames: where nothing moves it is not forgotten at once
      history.rgb = still ? mix(history.rgb, believed, 0.5) : believed;
    }
    // a bright point that comes and goes counts less (Karis); light that the display can show counts whole
    // what moves blurs at each look into the past: it is looked at less
    float share = still ? farol_share.y : farol_share.x;
    float ofNew = share / max(1.0, max(farol_color.r, max(farol_color.g, farol_color.b)));
    float ofOld = (1.0 - share) / max(1.0, max(history.r, max(history.g, history.b)));
    farol_color = (farol_color * ofNew + history * ofOld) / (ofNew + ofOld);
  }
}
