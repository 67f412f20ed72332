// Temporal anti-aliasing: the history of each cell of a pixel, mixed with this frame's sample by its distance to the
// cell.
// Yang et al. 2009, Amortized Supersampling (cells); Karis 2014, High Quality Temporal Supersampling; Salvi 2016, An
// Excursion in Temporal Supersampling (variance clipping)
#include "displayTransfer"
#include "taaDepth"
#include "lanczosCross"
uniform highp sampler2D farol_picture;
uniform highp sampler2D farol_history;
uniform highp sampler2D farol_reach; // distances of taaNear.glsl, this frame
uniform highp sampler2D farol_reachBefore; // distances of taaNear.glsl, last frame
uniform int farol_cells; // history cells along a pixel's side
uniform highp vec2 farol_sizeBefore; // size of the picture in the last frame (pixels)
uniform highp vec4 farol_weights; // weight of this frame's sample in each cell of a pixel, 0 to 1
uniform bool farol_encoded;
uniform bool farol_hasPast;
uniform highp vec2 farol_share; // share of a new sample of weight 1: x in moving pixels, y in still ones
uniform float farol_gamma; // standard deviations to which history is clipped; 0: no clipping, in a still picture
// 0: lights have changed; 1: lights may have changed; 2: lights are unchanged; 3: also the camera, and no object has
// just appeared or vanished; 4: as 3, but the camera has moved
uniform int farol_belief;
// reactive masks of this and the last frame: least share of the new sample, 0 to 1, where history is unreliable
uniform highp sampler2D farol_reactive;
uniform highp sampler2D farol_reactiveBefore;
uniform highp ivec2 farol_isReactive; // x, y: 1 if the textures farol_reactive and farol_reactiveBefore are bound
layout(location = 0) out highp vec4 farol_color;

/** Ratio of two distances above which they belong to different surfaces. */
const float FAROL_APART = 1.08;
/** Motion of foreground over background (pixels a frame) from which on history at the edge is doubted. */
const float FAROL_PASSES = 0.3;
/** Parallax (pixels a frame) up to which a thin foreground that no sample hits counts as still present. */
const float FAROL_ALONG = 0.2;

// maximum over 3 × 3 pixels, since jitter may have shifted a neighbour here
float farol_reactiveAt(const in highp sampler2D mask, const in ivec2 pixel) {
  float most = 0.0;
  for (int y = -1; y <= 1; y++) for (int x = -1; x <= 1; x++)
    most = max(most, texelFetch(mask, farol_inPicture(pixel + ivec2(x, y)), 0).r);
  return most;
}

vec4 farol_pictureAt(const in ivec2 pixel) {
  vec4 color = texelFetch(farol_picture, farol_inPicture(pixel), 0);
  return farol_encoded ? farol_toLinear(color) : color;
}

vec4 farol_toYCoCg(const in vec4 c) {
  return vec4(0.25 * (c.r + c.b) + 0.5 * c.g, 0.5 * (c.r - c.b), 0.5 * c.g - 0.25 * (c.r + c.b), c.a);
}

vec4 farol_fromYCoCg(const in vec4 c) {
  float t = c.x - c.z;
  return vec4(t + c.y, c.x + c.z, t - c.y, c.a);
}

// history clipped to gamma standard deviations of a sample and its four neighbours, in YCoCg (variance clipping)
vec4 farol_likeNow(const in vec4 past, const in ivec2 pixel, const in float gamma) {
  vec4 sum = vec4(0.0);
  vec4 squares = vec4(0.0);
  for (int i = 0; i < 5; i++) {
    ivec2 off = ivec2(i == 1 ? 1 : i == 2 ? -1 : 0, i == 3 ? 1 : i == 4 ? -1 : 0);
    vec4 c = farol_toYCoCg(farol_pictureAt(pixel + off));
    sum += c;
    squares += c * c;
  }
  vec4 mean = sum / 5.0;
  vec4 reach = gamma * sqrt(max(squares / 5.0 - mean * mean, 0.0));
  vec4 off = farol_toYCoCg(past) - mean;
  vec4 ratio = abs(off) / max(reach, 1e-5);
  return farol_fromYCoCg(mean + off / max(max(max(ratio.x, ratio.y), max(ratio.z, ratio.w)), 1.0));
}

// history moved half way to the nearest mixture of two colours, since an edge between them can only show mixtures
vec4 farol_between(const in vec4 past, const in vec4 one, const in vec4 other) {
  vec4 way = other - one;
  return mix(past, one + way * clamp(dot(past - one, way) / max(dot(way, way), 1e-6), 0.0, 1.0), 0.5);
}

// of the 3 × 3 samples around a pixel with a distance up to farthest (m), the nearest to place (in samples)
ivec2 farol_foreground(const in ivec2 pixel, const in vec2 place, const in float farthest, const in ivec2 otherwise) {
  ivec2 found = otherwise;
  float least = 1e9;
  for (int y = -1; y <= 1; y++) for (int x = -1; x <= 1; x++) {
    ivec2 at = farol_inPicture(pixel + ivec2(x, y));
    vec2 off = vec2(pixel + ivec2(x, y)) - place;
    if (dot(off, off) < least && farol_distanceAt(at) <= farthest) { least = dot(off, off); found = at; }
  }
  return found;
}
//# main
ivec2 cell = ivec2(gl_FragCoord.xy);
ivec2 pixel = cell / farol_cells;
ivec2 part = cell - pixel * farol_cells;
vec2 size = farol_frameSize;
vec2 place = gl_FragCoord.xy / float(farol_cells);
// jitter shifts samples from the middle of pixels
vec2 inSamples = place - 0.5 + 0.5 * farol_jitter * size;
ivec2 own = farol_inPicture(ivec2(floor(inSamples + 0.5)));
float weight = farol_weights[part.y * farol_cells + part.x];
farol_color = farol_pictureAt(own);
if (farol_hasPast && farol_gamma <= 0.0) farol_color = mix(texelFetch(farol_history, cell, 0), farol_color, weight);
else if (farol_hasPast) {
  vec2 reach = texelFetch(farol_reach, pixel, 0).xy;
  float nearest = abs(reach.x);
  bool edge = reach.y > nearest * FAROL_APART;
  float split = 2.0 * nearest * reach.y / (nearest + reach.y);
  float away = farol_distanceAt(own);
  ivec2 shown = own;
  // next to an edge, history follows the motion of the foreground, which covers part of the cell
  if (edge && away > split) shown = farol_foreground(pixel, inSamples, split, own);
  bool beside = shown != own;
  vec3 ownWay = farol_wayOf(own, away);
  float shownDistance = beside ? farol_distanceAt(shown) : away;
  vec3 way = beside ? farol_wayOf(shown, shownDistance) : ownWay;
  vec2 uv = place / size - way.xy;
  bool resized = farol_sizeBefore != size;
  bool still = !resized && all(lessThan(abs(way.xy * size), vec2(1e-3)));
  if (uv == clamp(uv, 0.0, 1.0)) {
    vec4 past = still ? texelFetch(farol_history, cell, 0)
      : max(farol_lanczosCross(farol_history, uv, farol_sizeBefore * float(farol_cells)), 0.0);
    // history is believed if last frame's nearest surface there has the expected distance, or if nothing moves
    float before = texelFetch(farol_reachBefore, min(ivec2(uv * farol_sizeBefore), ivec2(farol_sizeBefore) - 1), 0).x;
    float expected = nearest * way.z / shownDistance;
    bool same = abs(abs(before) - expected) < (FAROL_APART - 1.0) * expected;
    bool stays = farol_belief == 3 && still && reach.x > 0.0 && (same || before > 0.0);
    // samples may have missed a foreground thinner than their spacing
    bool missed = farol_belief > 2 && !same && reach.x > 0.0 && before > 0.0 && before < expected
      && length((farol_wayAt(place / size, before) - way.xy) * size) < FAROL_ALONG;
    bool believed = stays || missed || (farol_belief > 0 && edge && same);
    if (!believed || farol_belief < 2)
      past = farol_likeNow(past, pixel, believed ? 2.0 * farol_gamma : farol_gamma);
    float reactive = farol_isReactive.x > 0 ? farol_reactiveAt(farol_reactive, own) : 0.0;
    if (farol_isReactive.y > 0)
      reactive = max(reactive, farol_reactiveAt(farol_reactiveBefore, ivec2(uv * farol_sizeBefore)));
    float share = weight * (still ? farol_share.y : farol_share.x);
    // where the history is doubted, samples farther from the cell's centre count more
    if (edge && !believed) share = max(share, farol_share.x * pow(weight, 0.36));
    if (beside) {
      float passes = length((way.xy - ownWay.xy) * size);
      if (passes > FAROL_PASSES) past = farol_between(past, farol_color, farol_pictureAt(shown));
      if (passes > 0.3 * FAROL_PASSES) share = max(share, farol_share.x * pow(weight, 0.7));
    }
    share = max(share, reactive);
    // weights bright, flickering samples less (Karis); colours within the display's range keep full weight
    float ofNew = share / max(1.0, max(farol_color.r, max(farol_color.g, farol_color.b)));
    float ofOld = (1.0 - share) / max(1.0, max(past.r, max(past.g, past.b)));
    farol_color = (farol_color * ofNew + past * ofOld) / max(ofNew + ofOld, 1e-6);
  }
}
