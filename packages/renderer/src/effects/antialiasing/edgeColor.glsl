// Finds a surface's colour in a picture with one surface a pixel, by depth: of its own pixel, or of the neighbour
// whose depth is nearest to the plane of the fragment's triangle.
// Chajdas, McGuire and Luebke 2011, Subpixel Reconstruction Antialiasing
#include "frameSize"
uniform highp sampler2D farol_picture;
uniform highp sampler2D farol_pictureDepth;

/** Greatest rounding error of a depth-buffer value. */
const float FAROL_ROUNDING = 2e-7;
/** Added to the alpha of a sample whose surface the picture shows; can be told from alpha in a mean of 4 samples. */
const float FAROL_SHOWN = 8.0;

/**
 * Whether the picture shows the surface.
 * @param depth - stored depth of the surface at the pixel
 * @param slope - change of that depth to the next pixel in x, y
 * @param fit - greatest accepted difference of depth, as a share of the slope
 * @param nearby - whether to search the eight neighbours too
 * @param color - the picture's colour at the pixel that shows the surface, else at the pixel itself
 * @param shown - FAROL_SHOWN if the pixel itself shows the surface, else 0
 */
bool farol_edgeColor(
  const in ivec2 pixel, const in float depth, const in vec2 slope, const in float fit, const in bool nearby,
  out vec4 color, out float shown
) {
  float slopes = abs(slope.x) + abs(slope.y);
  float least = abs(texelFetch(farol_pictureDepth, pixel, 0).r - depth);
  float most = FAROL_ROUNDING + fit * slopes;
  ivec2 found = pixel;
  shown = least <= 2.0 * FAROL_ROUNDING + slopes ? FAROL_SHOWN : 0.0;
  if (nearby && least > most) {
    ivec2 last = ivec2(farol_frameSize) - 1;
    for (int y = -1; y <= 1; y++) for (int x = -1; x <= 1; x++) {
      ivec2 at = clamp(pixel + ivec2(x, y), ivec2(0), last);
      vec2 off = vec2(at - pixel);
      // of several pixels whose depth fits the sample, the nearest in depth is found
      float apart = abs(texelFetch(farol_pictureDepth, at, 0).r - depth - dot(slope, off))
        + (FAROL_ROUNDING + 0.01 * slopes) * dot(off, off);
      if (apart < least) { least = apart; found = at; }
    }
    most += (FAROL_ROUNDING + 0.01 * slopes) * 2.0;
  }
  color = texelFetch(farol_picture, least <= most ? found : pixel, 0);
  return least <= most;
}
