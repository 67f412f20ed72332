// Reads the light buffer, of any resolution, for a pixel of the picture, by a filter that respects edges of objects.
// Kircher and Lawrance 2009, Inferred Lighting: Fast dynamic lighting and shadows for opaque and translucent objects
#include "thinGBufferRead"
#include "lightSums"
varying highp vec2 farol_object; // x: object number; y: its corner of the 2 × 2 stipple, 0: all texels
uniform highp sampler2D farol_sums0;
uniform highp sampler2D farol_sums1;
uniform highp sampler2D farol_sums2;
#ifdef FAROL_AREA_LIGHTS
uniform highp sampler2D farol_sums3;
#endif
uniform highp vec2 farol_size; // size of the light buffer (texels)
uniform highp vec4 farol_lightGrid; // xy: light buffer texels per pixel; zw: offset of the picture (pixels)

struct FarolReader {
  vec3 positionVS;
  vec3 normalVS;
  float object;
  vec2 size; // size of the light buffer (texels)
  float reach; // largest distance of an agreeing texel from the tangent plane (m): two texels' width at that depth
  int stride; // 2 for a stippled layer: every second texel
  ivec2 corner; // the layer's texel in each 2 × 2, or 0
  ivec2 last; // last texel in steps of the stride
  vec4 sums0;
  vec4 sums1;
  vec4 sums2;
#ifdef FAROL_AREA_LIGHTS
  vec4 sums3;
#endif
  float total; // sum of the weights
};

ivec2 farol_texelAt(const in FarolReader reader, const in ivec2 place) {
  return clamp(place, ivec2(0), reader.last) * reader.stride + reader.corner;
}

// x: agreement of a texel with the surface, 0 (another object or depth) to 1; y: disagreement, least for the best
// fallback
vec2 farol_agreement(const in FarolReader reader, const in ivec2 texel) {
  vec4 thin = texelFetch(farol_thinSurface, texel, 0);
  vec3 there = farol_thinPosition(texel, reader.size);
  float off = abs(dot(there - reader.positionVS, reader.normalVS)) / reader.reach;
  float cosine = clamp(dot(farol_decodeNormal(thin.xy), reader.normalVS), 0.0, 1.0);
  bool same = abs(thin.w) == reader.object;
  // falls to half at 8 degrees: light changes faster with the normal than with position
  float agreement = same && off < 1.0 ? pow(cosine, 64.0) : 0.0;
  float nothing = 1e6;
  return vec2(agreement, (thin.w == 0.0 ? nothing : same ? 0.0 : 4.0) + min(off, 100.0) + 1.0 - cosine);
}

void farol_addTexel(inout FarolReader reader, const in ivec2 texel, const in float weight) {
  // clamped, since half floats may have overflowed to infinity, and 0 × infinity would be NaN
  reader.sums0 += weight * min(texelFetch(farol_sums0, texel, 0), 65504.0);
  reader.sums1 += weight * min(texelFetch(farol_sums1, texel, 0), 65504.0);
  reader.sums2 += weight * min(texelFetch(farol_sums2, texel, 0), 65504.0);
#ifdef FAROL_AREA_LIGHTS
  reader.sums3 += weight * min(texelFetch(farol_sums3, texel, 0), 65504.0);
#endif
  reader.total += weight;
}

void farol_clearTexels(inout FarolReader reader) {
  reader.sums0 = reader.sums1 = reader.sums2 = vec4(0.0);
#ifdef FAROL_AREA_LIGHTS
  reader.sums3 = vec4(0.0);
#endif
  reader.total = 0.0;
}

// the four texels round the place, bilinear, without those that disagree
void farol_readBilinear(inout FarolReader reader, const in vec2 place) {
  ivec2 base = ivec2(floor(place));
  vec2 between = place - vec2(base);
  for (int i = 0; i < 4; i++) {
    ivec2 corner = ivec2(i & 1, i >> 1);
    vec2 part = mix(1.0 - between, between, vec2(corner));
    if (part.x * part.y == 0.0) continue;
    ivec2 texel = farol_texelAt(reader, base + corner);
    float weight = part.x * part.y * farol_agreement(reader, texel).x;
    if (weight > 0.0) farol_addTexel(reader, texel, weight);
  }
}

// sixteen texels round the place, nearer ones first; if none agrees, the one that disagrees least
void farol_readWide(inout FarolReader reader, const in vec2 place) {
  ivec2 base = ivec2(floor(place)) - 1;
  ivec2 fallback = ivec2(0);
  float least = 1e9;
  for (int i = 0; i < 16; i++) {
    ivec2 at = base + ivec2(i & 3, i >> 2);
    ivec2 texel = farol_texelAt(reader, at);
    vec2 agreement = farol_agreement(reader, texel);
    vec2 away = vec2(at) - place;
    float squared = dot(away, away);
    float weight = agreement.x / (0.25 + squared * squared);
    if (weight > 0.0) farol_addTexel(reader, texel, weight);
    agreement.y += 0.1 * squared;
    if (agreement.y < least) {
      least = agreement.y;
      fallback = texel;
    }
  }
  if (reader.total > 1e-4) return;
  farol_clearTexels(reader);
  farol_addTexel(reader, fallback, 1.0);
}

FarolLightSums farol_lightSums(const in vec3 positionVS, const in vec3 normalVS) {
  FarolReader reader;
  int slot = int(farol_object.y + 0.5);
  ivec2 size = ivec2(farol_size);
  reader.positionVS = positionVS;
  reader.normalVS = normalVS;
  reader.object = floor(farol_object.x + 0.5);
  reader.size = vec2(size);
  reader.reach = 4.0 * farol_unprojectXY.y / reader.size.y * mix(1.0, -positionVS.z, farol_perspective);
  reader.stride = slot > 0 ? 2 : 1;
  reader.corner = ivec2(slot & 1, slot >> 1);
  reader.last = (size - 1 - reader.corner) / reader.stride;
  vec2 texel = (gl_FragCoord.xy - farol_lightGrid.zw) * farol_lightGrid.xy - 0.5;
  vec2 place = (texel - vec2(reader.corner)) / float(reader.stride);
  farol_clearTexels(reader);
  farol_readBilinear(reader, place);
  if (reader.total < 0.2) {
    farol_clearTexels(reader);
    farol_readWide(reader, place);
  }
  vec3 specularF90 = vec3(reader.sums0.a, reader.sums1.a, reader.sums2.a);
  FarolLightSums sums;
  sums.diffuse = reader.sums0.rgb / reader.total;
  sums.rest = reader.sums1.rgb / reader.total;
  sums.specularF0 = reader.sums2.rgb / reader.total;
  sums.specularF90 = specularF90 / reader.total;
#ifdef FAROL_AREA_LIGHTS
  sums.area = reader.sums3.rgb / reader.total;
#endif
  return sums;
}
