import type { PictureSize } from '../lights/LightTable';

/** Texels of all shadow maps for a pixel of the picture, at most: twice as many change no pixel by what is seen. */
const TEXELS_PER_PIXEL = 48;
/** Pixels that a picture is taken to have at least. */
const LEAST_PIXELS = 1280 * 720;
/** Texels a side of the largest atlas, and by which sizes differ. */
const LARGEST = 8192;
const STEP = 256;

/**
 * Texels a side that the atlas of shadow maps grows to at most for a picture: where lights ask for more, the maps of those that
 * cover least of it are halved.
 */
export function atlasLimit({ width, height }: PictureSize): number {
  const texels = TEXELS_PER_PIXEL * Math.max(LEAST_PIXELS, width * height);
  return Math.min(LARGEST, Math.ceil(Math.sqrt(texels) / STEP) * STEP);
}
