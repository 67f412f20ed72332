// Samples the images that lights project, with filtering as by a GPU: the first few spot lights' textures directly;
// other textures, and point lights' cubes, from copies in the atlas of colours.
// OpenGL ES 3.0, 3.8.9 and 3.8.10 (levels); EXT_texture_filter_anisotropic (samples along the longer side of a pixel)
#include "imageSamplers"
#include "maskFeatures"
#include "maskRecord"
#include "readPixel"
uniform highp sampler2D farol_lightAtlas; // cookies: linear colours; VSM: mean and standard deviation of depths
uniform highp vec2 farol_atlasTexel; // 1 / side (texels): x of the shadow atlas, y of the colour atlas

// normal (view space) of the surface's plane in this pixel; 0: unknown. Set by derivatives before the light loop
// (within it they are undefined), or by the first light's farol_planeNormal
vec3 farol_planeVS = vec3(0.0);
#ifdef FAROL_LIGHT_COOKIES
#define FAROL_SET_PLANE(positionVS) farol_planeVS = cross(dFdx(positionVS), dFdy(positionVS));

// Copy of an image, or a face of the copy of a cube.
struct FarolImage {
  vec4 region; // region of the cookie in the atlas, by farol_maskCookie
  ivec2 faces; // number of faces across and up: (1, 1), for a cube (3, 2)
  ivec2 face; // column and row of the face in the copy of a cube
};

// colour of an image in one mipmap level; layout of levels: atlas/mipmapBlock.ts
vec3 farol_imageLevel(const in FarolImage image, const in vec2 uv, const in int level, const in bool nearest) {
  ivec2 base = ivec2(image.region.zw);
  ivec2 size = max(base >> level, 1);
  ivec2 corner = ivec2(image.region.xy) + 1 + image.face * (size + 2);
  if (level > 0) corner.y += image.faces.y * (base.y + 2);
  if (level > 1) corner.x += image.faces.x * (max(base.x >> 1, 1) + 2);
  for (int i = 2; i < level; i++) corner.y += image.faces.y * (max(base.y >> i, 1) + 2);
  vec2 texel = uv * vec2(size);
  if (nearest) texel = clamp(floor(texel), vec2(0.0), vec2(size - 1)) + 0.5;
  return textureLod(farol_lightAtlas, (vec2(corner) + texel) * farol_atlasTexel.y, 0.0).rgb;
}

// colour of an image; level: mipmap level that derivatives would give; filtering: see slots/imageFilter.ts
vec3 farol_imageAt(const in FarolImage image, const in vec2 uv, const in float level, const in int filtering) {
  bool nearest = (filtering & 2) != 0;
  float magnified = (filtering & 15) == 6 || (filtering & 15) == 10 ? 0.5 : 0.0;
  int last = filtering >> 4 & 15;
  float between = 0.0;
  if (level <= magnified) nearest = (filtering & 1) != 0;
  else if ((filtering & 8) != 0) between = min(level, float(last));
  else if ((filtering & 4) != 0) between = float(min(int(ceil(level + 0.5)) - 1, last));
  int lower = int(between);
  vec3 color = farol_imageLevel(image, uv, lower, nearest);
  if (between == float(lower)) return color;
  return mix(color, farol_imageLevel(image, uv, lower + 1, nearest), between - float(lower));
}

// Coordinates in a light's map (0..1) of three pixels of a 2 × 2 quad, for one mipmap level for all four, as GPUs
// choose it. Computed from the surface's plane, since derivatives are undefined in a loop over lights.
struct FarolQuad {
  vec2 first;
  vec2 beside;
  vec2 above;
};

// place in a map of the pixel at an offset (pixels right and up) from the surface's pixel; coord: surface's place
vec2 farol_placeBeside(const in mat4 matrix, const in vec4 coord, const in vec2 pixels, const in vec2 pixelSpan,
  const in vec3 positionVS, const in vec3 normalVS) {
  vec3 shift = vec3(pixels * abs(pixelSpan), 0.0);
  bool isPerspective = pixelSpan.x > 0.0;
  vec3 from = isPerspective ? vec3(0.0) : positionVS + shift;
  vec3 viewRay = isPerspective ? positionVS / -positionVS.z + shift : vec3(0.0, 0.0, -1.0);
  float facing = dot(normalVS, viewRay);
  facing = facing > 0.0 ? max(facing, 0.01) : min(facing, -0.01);
  vec3 there = from + viewRay * (dot(normalVS, positionVS - from) / facing);
  vec4 moved = coord + matrix * vec4(there - positionVS, 0.0);
  return moved.xy / moved.w;
}

// distance (m) of a depth from the line through the depths of the next two pixels
float farol_bendAt(const in float z, const in float next, const in float second, const in bool isPerspective) {
  return abs(z - (isPerspective ? next * second / (2.0 * second - next) : 2.0 * next - second));
}

// change of position to the next pixel of the G-buffer, on the side where the next two pixels lie on one line with
// this one (the same triangle); where that is so on no side, the change is towards the neighbour nearer in depth, and
// bend exceeds limit (both m)
vec3 farol_changeAlong(const in ivec2 along, const in vec3 positionVS, const in bool isPerspective,
  const in float limit, inout float bend) {
  ivec2 last = ivec2(farol_readSize) - 1;
  vec3 next = FAROL_POSITION_AT(min(farol_readPixel + along, last));
  vec3 before = FAROL_POSITION_AT(max(farol_readPixel - along, 0));
  float second = FAROL_POSITION_AT(min(farol_readPixel + 2 * along, last)).z;
  float secondBefore = FAROL_POSITION_AT(max(farol_readPixel - 2 * along, 0)).z;
  bool isFirst = any(lessThan(farol_readPixel - along, ivec2(0)));
  bool isLast = any(greaterThan(farol_readPixel + along, last));
  float bendAfter = isLast ? 1e9 : farol_bendAt(positionVS.z, next.z, second, isPerspective);
  float bendBefore = isFirst ? 1e9 : farol_bendAt(positionVS.z, before.z, secondBefore, isPerspective);
  float least = min(bendAfter, bendBefore);
  bend = max(bend, least);
  bool isNext = least < limit ? bendAfter < bendBefore : abs(next.z - positionVS.z) < abs(before.z - positionVS.z);
  return isFirst || (!isLast && isNext) ? next - positionVS : positionVS - before;
}

// normal of the surface's plane in its pixel; for a G-buffer, from neighbouring pixels. Triangles of a pixel or two
// have no neighbours of their own: there the surface's normal, if the pixels' normal is within 10 degrees of it
vec3 farol_planeNormal(const in vec3 positionVS, const in vec3 normalVS, const in vec2 pixelSpan) {
  if (farol_readSize.x > 0.0 && farol_planeVS == vec3(0.0)) {
    bool isPerspective = pixelSpan.x > 0.0;
    float limit = 0.05 * abs(pixelSpan.x) * (isPerspective ? -positionVS.z : 1.0);
    float bend = 0.0;
    vec3 right = farol_changeAlong(ivec2(1, 0), positionVS, isPerspective, limit, bend);
    vec3 up = farol_changeAlong(ivec2(0, 1), positionVS, isPerspective, limit, bend);
    farol_planeVS = normalize(cross(right, up));
    if (bend > limit && abs(dot(farol_planeVS, normalVS)) > 0.985) farol_planeVS = normalVS;
  }
  float size = length(farol_planeVS);
  return size > 0.0 ? farol_planeVS / size : normalVS;
}

// position of a pixel and its neighbours in the map of a mask record; matrix: from view space to the map
FarolQuad farol_quadOf(const in int record, const in mat4 matrix, const in vec4 coord, const in vec3 positionVS,
  const in vec3 normalVS) {
  vec2 span = farol_maskPixelSpan(record);
  vec3 planeVS = farol_planeNormal(positionVS, normalVS, span);
#ifdef FAROL_PER_VERTEX
  vec2 first = vec2(0.0);
#else
  vec2 first = -vec2(ivec2(gl_FragCoord.xy) & 1);
#endif
  return FarolQuad(farol_placeBeside(matrix, coord, first, span, positionVS, planeVS),
    farol_placeBeside(matrix, coord, first + vec2(1.0, 0.0), span, positionVS, planeVS),
    farol_placeBeside(matrix, coord, first + vec2(0.0, 1.0), span, positionVS, planeVS));
}

// colour of a texture itself, or of an image's copy, filtered over a pixel; coord: homogeneous, 0..1
vec3 farol_imageOn(const in int record, const in FarolImage image, const in mat4 matrix, const in vec4 coord,
  const in vec3 positionVS, const in vec3 normalVS) {
  int filtering = farol_maskCookieFilter(record);
  vec2 place = coord.xy / coord.w;
  float level = -1.0;
  vec2 along = vec2(0.0);
  int samples = 1;
  // codes 0 and 3: one filter for magnified and minified images, so that no level is needed
  if ((filtering & 255) != 0 && (filtering & 255) != 3) {
    FarolQuad quad = farol_quadOf(record, matrix, coord, positionVS, normalVS);
    vec2 right = quad.beside - quad.first;
    vec2 up = quad.above - quad.first;
    if (filtering < 0) return farol_imageTexel(-filtering - 1, place, right, up);
    vec2 size = image.region.zw;
    vec2 texels = vec2(length(right * size), length(up * size));
    float longer = max(texels.x, texels.y);
    float ratio = 1.0;
    int most = filtering >> 8;
    if (most >= 2) {
      along = texels.x > texels.y ? right : up;
      float area = abs(right.x * up.y - right.y * up.x) * size.x * size.y;
      ratio = clamp(longer * longer / max(area, 1e-9), 1.0, float(most));
      samples = int(ratio + 0.5);
    }
    level = log2(longer / ratio);
  }
  vec3 sum = vec3(0.0);
  for (int i = 0; i < samples; i++) {
    vec2 uv = place + along * ((float(i) + 0.5) / float(samples) - 0.5);
    sum += farol_imageAt(image, clamp(uv, 0.0, 1.0), level, filtering);
  }
  return sum / float(samples);
}

// Colour of a light's image at a surface; white outside of the image. For a cube, by the face it shines through.
// coord: coordinates in the light's map (homogeneous, 0..1); for a cube, from the light to the surface (world axes)
// axes: from view space to world axes
vec3 farol_cookieAt(const in int record, const in vec4 coord, const in bool isCube, const in mat3 axes,
  const in vec3 positionVS, const in vec3 normalVS) {
  FarolImage image = FarolImage(farol_maskCookie(record), ivec2(1), ivec2(0));
  mat4 matrix;
  vec4 place = coord;
  if (isCube) {
    vec3 size = abs(coord.xyz);
    vec3 side = vec3(coord.x < 0.0 ? -1.0 : 1.0, coord.y < 0.0 ? -1.0 : 1.0, coord.z < 0.0 ? -1.0 : 1.0);
    // axes of the face in farol_cubeFace (lightShadow): right, up, away
    mat3 face = mat3(-side.z, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, side.z);
    float index = 4.5 - 0.5 * side.z;
    if (size.x >= size.y && size.x >= size.z) {
      face = mat3(0.0, 0.0, side.x, 0.0, 1.0, 0.0, side.x, 0.0, 0.0);
      index = 0.5 - 0.5 * side.x;
    } else if (size.y >= size.z) {
      face = mat3(side.y, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, side.y, 0.0);
      index = 2.5 - 0.5 * side.y;
    }
    vec3 away = face[2];
    matrix = transpose(mat4(vec4(0.5 * (face[0] + away), 0.0), vec4(0.5 * (face[1] + away), 0.0), vec4(0.0),
      vec4(away, 0.0)));
    place = matrix * vec4(coord.xyz, 0.0);
    matrix *= mat4(axes);
    int cell = int(index);
    image.faces = ivec2(3, 2);
    image.face = ivec2(cell % 3, cell / 3);
  } else {
    if (any(greaterThanEqual(abs(coord.xyz / coord.w * 2.0 - 1.0), vec3(1.0)))) return vec3(1.0);
    matrix = farol_maskMatrix(record);
  }
  return farol_imageOn(record, image, matrix, place, positionVS, normalVS);
}
#endif
