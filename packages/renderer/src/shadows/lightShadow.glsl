// Shadow maps and cookies of lights, from the tiles of two atlases; the filters are three's own.
// three.js r187 shadowmap_pars_fragment; Reeves et al. 1987 (PCF); Donnelly and Lauritzen 2006 (VSM); Jimenez 2014 (noise)
//? farol_cubeFace(vec3(2.0, 1.0, 1.0)) == vec3(0.75, 0.75, 0.0)
//? farol_cubeFace(vec3(0.0, 0.5, -2.0)) == vec3(0.5, 0.625, 5.0)
#include "lightTable"
uniform highp sampler2DShadow farol_shadowAtlas;
uniform highp sampler2D farol_lightAtlas; // linear colours, or mean and deviation of depths

// the five samples of three's disk before it is turned
const vec2 FAROL_DISK[5] = vec2[5](vec2(0.31622777, 0.0), vec2(-0.40387357, 0.36998127), vec2(0.06181932, -0.70439930),
  vec2(0.50905647, 0.66397403), vec2(-0.93418124, -0.16524351));

// the part of a cube map's face that a direction meets: x and y in 0..1, then the face (+x -x +y -y +z -z)
vec3 farol_cubeFace(const in vec3 direction) {
  vec3 size = abs(direction);
  vec3 side = vec3(direction.x < 0.0 ? -1.0 : 1.0, direction.y < 0.0 ? -1.0 : 1.0, direction.z < 0.0 ? -1.0 : 1.0);
  if (size.x >= size.y && size.x >= size.z) return vec3(vec2(side.x * direction.z, direction.y) / size.x * 0.5 + 0.5, 0.5 - 0.5 * side.x);
  if (size.y >= size.z) return vec3(vec2(side.y * direction.x, direction.z) / size.y * 0.5 + 0.5, 2.5 - 0.5 * side.y);
  return vec3(vec2(-side.z * direction.x, direction.y) / size.z * 0.5 + 0.5, 4.5 - 0.5 * side.z);
}

// texels of an atlas; tile: corner of the first face, texels a side of a face, texels from face to face
vec2 farol_cubeTexel(const in vec4 tile, const in vec3 face, const in bool nearest) {
  vec2 cell = vec2(mod(face.z, 3.0), floor(face.z / 3.0 + 0.01));
  vec2 texel = face.xy * tile.z;
  if (nearest) texel = min(floor(texel), tile.z - 1.0) + 0.5;
  return tile.xy + cell * tile.w + 0.5 * (tile.w - tile.z) + texel;
}

float farol_shadowTap(const in vec2 texel, const in float depth) {
  return textureLod(farol_shadowAtlas, vec3(texel / vec2(textureSize(farol_shadowAtlas, 0)), depth), 0.0);
}

mat2 farol_diskTurn() {
  float angle = 6.28318530718 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  return mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
}

// tile: corner and size (texels); coord: across the map 0..1, and depth; radius: texels of the map as asked for
float farol_mapShadow(const in int kind, const in vec4 tile, const in vec3 coord, const in vec2 mapSize, const in float radius) {
  vec2 texel = tile.xy + coord.xy * tile.zw;
  vec2 first = tile.xy + 0.5;
  vec2 last = tile.xy + tile.zw - 0.5;
  if (kind == 1) return farol_shadowTap(clamp(floor(texel) + 0.5, first, last), coord.z);
  if (kind == 2) {
    mat2 turn = farol_diskTurn();
    vec2 scale = radius * tile.zw / mapSize;
    float lit = 0.0;
    for (int i = 0; i < 5; i++) lit += farol_shadowTap(clamp(texel + turn * FAROL_DISK[i] * scale, first, last), coord.z);
    return lit * 0.2;
  }
  vec2 moments = textureLod(farol_lightAtlas, clamp(texel, first, last) / vec2(textureSize(farol_lightAtlas, 0)), 0.0).rg;
  if (coord.z <= moments.x) return 1.0;
  float variance = max(moments.y * moments.y, 0.0000001);
  float beyond = coord.z - moments.x;
  return clamp((variance / (variance + beyond * beyond) - 0.3) / 0.65, 0.0, 1.0);
}

// the same in the first map that holds the place, of a directional light that has nearer maps, two a row
float farol_cascadeShadow(const in int record, const in int kind, const in vec4 tile, const in vec3 coord, const in vec2 mapSize, const in float radius) {
  vec3 across = coord;
  int nearer = int(farol_lightTexel(record + 1, 3).x);
  int map = nearer;
  for (int i = 0; i < nearer; i++) {
    vec4 fit = farol_lightTexel(record + 2, i == 2 ? 0 : i + 2);
    vec2 there = coord.xy * fit.xz + fit.yw;
    if (max(abs(there.x - 0.5), abs(there.y - 0.5)) > 0.48) continue;
    across.xy = there;
    map = i;
    break;
  }
  return farol_mapShadow(kind, vec4(tile.xy + vec2(map & 1, map >> 1) * tile.zw, tile.zw), across, mapSize, radius);
}

// depths: a and b of a face's depth a + b / distance along its axis, then nearest and farthest (m)
float farol_cubeShadow(const in int kind, const in vec4 tile, const in vec3 fromLight, const in vec4 depths, const in vec2 mapSize, const in float radius) {
  vec3 size = abs(fromLight);
  float along = max(max(size.x, size.y), size.z);
  if (along > depths.w || along < depths.z) return 1.0;
  if (kind == 3) return farol_shadowTap(farol_cubeTexel(tile, farol_cubeFace(fromLight), true), depths.x + depths.y / along);
  float fromLightLength = length(fromLight);
  vec3 direction = fromLight / fromLightLength;
  vec3 tangent = normalize(cross(direction, abs(direction.x) > abs(direction.z) ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
  vec3 bitangent = cross(direction, tangent);
  mat2 turn = farol_diskTurn();
  float scale = radius / mapSize.x;
  float lit = 0.0;
  for (int i = 0; i < 5; i++) {
    vec2 offset = turn * FAROL_DISK[i] * scale;
    vec3 towards = direction + tangent * offset.x + bitangent * offset.y;
    size = abs(towards);
    float depth = depths.x + depths.y / (fromLightLength * max(max(size.x, size.y), size.z));
    lit += farol_shadowTap(farol_cubeTexel(tile, farol_cubeFace(towards), false), depth);
  }
  return lit * 0.2;
}

mat4 farol_maskMatrix(const in int record) {
  return mat4(farol_lightTexel(record, 0), farol_lightTexel(record, 1), farol_lightTexel(record, 2), farol_lightTexel(record, 3));
}

// where a point is in a map (homogeneous, 0..1), or from a point light (m); filtering: texel 5 of the mask
vec4 farol_maskCoord(const in int record, const in vec3 positionVS, const in vec3 shadowNormalVS, const in vec4 filtering) {
  return farol_maskMatrix(record) * vec4(positionVS + shadowNormalVS * filtering.y, 1.0);
}

// 1 in the light, 0 in full shadow; shape: texel 6 of the mask
float farol_litAt(const in int record, const in vec4 coord, const in vec4 filtering, const in vec4 shape) {
  int kind = int(shape.x);
  if (kind == 0) return 1.0;
  vec4 tile = farol_lightTexel(record + 1, 0);
  float lit = 1.0;
  if (kind == 3 || kind == 4) {
    lit = farol_cubeShadow(kind, tile, coord.xyz, farol_lightTexel(record + 1, 3), shape.yz, filtering.z);
  } else {
    vec3 across = coord.xyz / coord.w + vec3(0.0, 0.0, filtering.x);
    bool inside = all(greaterThanEqual(across.xy, vec2(0.0))) && all(lessThanEqual(across, vec3(1.0)));
    if (inside) lit = farol_cascadeShadow(record, kind, tile, across, shape.yz, filtering.z);
  }
  return mix(1.0, lit, filtering.w);
}

float farol_lightLit(const in int record, const in vec3 positionVS, const in vec3 shadowNormalVS) {
  vec4 filtering = farol_lightTexel(record + 1, 1);
  return farol_litAt(record, farol_maskCoord(record, positionVS, shadowNormalVS, filtering), filtering, farol_lightTexel(record + 1, 2));
}

// what the image of a light has there; shape: texel 6 of the mask
vec3 farol_cookieAt(const in int record, const in vec4 coord, const in vec4 shape) {
  vec4 tile = farol_lightTexel(record + 2, 0);
  vec2 texel;
  if (shape.w == 1.0) {
    vec3 across = coord.xyz / coord.w;
    if (any(greaterThanEqual(abs(across * 2.0 - 1.0), vec3(1.0)))) return vec3(1.0);
    texel = clamp(tile.xy + across.xy * tile.zw, tile.xy + 0.5, tile.xy + tile.zw - 0.5);
  } else texel = farol_cubeTexel(tile, farol_cubeFace(coord.xyz), false);
  return textureLod(farol_lightAtlas, texel / vec2(textureSize(farol_lightAtlas, 0)), 0.0).rgb;
}

// how much of the light a mask lets through to a point, by colour; receives: false where shadows do not count
vec3 farol_lightMask(const in int record, const in vec3 positionVS, const in vec3 shadowNormalVS, const in bool receives) {
  vec4 filtering = farol_lightTexel(record + 1, 1); // bias, normal bias (m), radius (texels), intensity
  vec4 shape = farol_lightTexel(record + 1, 2); // kind, map size, kind of cookie
  vec4 coord = farol_maskCoord(record, positionVS, shadowNormalVS, filtering);
  vec3 passed = shape.w > 0.0 ? farol_cookieAt(record, coord, shape) : vec3(1.0);
  if (receives) passed *= farol_litAt(record, coord, filtering, shape);
  return passed;
}
