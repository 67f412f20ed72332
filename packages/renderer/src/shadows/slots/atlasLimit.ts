import type { PictureSize } from '../../lights/PictureSize';
import type { ShadowSlot } from './ShadowSlot';

/**
 * Maximum number of shadow-map texels for each pixel of the picture, in the maps of lights with a range: fewer would
 * show, see docs/performance.md.
 */
const TEXELS_PER_PIXEL = 48;
/** Smallest number of pixels that the atlas is sized for, even if the picture is smaller. */
const LEAST_PIXELS = 1280 * 720;
/** Greatest side of an atlas of shadow maps (texels). */
const LARGEST = 8192;
/** Step in which the side of the atlas grows (texels). */
const STEP = 256;

/** Maximum size in bytes of an atlas for each pixel of the picture, with the quality 'lite'. */
const LITE_BYTES_PER_PIXEL = 10;

type Asking = Pick<ShadowSlot, 'range' | 'isCube' | 'side' | 'wantedWidth' | 'wantedHeight'>;

/**
 * Greatest side (texels) of the atlas of shadow maps for a picture: beyond it, the maps of lights that cover least of the
 * picture are halved. The maps of lights without a range raise the limit by their size.
 */
export function atlasLimit({ width, height }: PictureSize, slots: readonly Asking[]): number {
  let texels = TEXELS_PER_PIXEL * Math.max(LEAST_PIXELS, width * height);
  let widest = 0;
  for (const { range, isCube, side, wantedWidth, wantedHeight } of slots) {
    if (range !== Infinity) continue;
    texels += wantedWidth * wantedHeight * (isCube ? 6 : side * side);
    widest = Math.max(widest, wantedWidth * side, wantedHeight * side);
  }
  return Math.min(LARGEST, Math.ceil(Math.max(Math.sqrt(texels), widest) / STEP) * STEP);
}

/** Maximum size in bytes of an atlas with the quality 'lite', for any number of lights. */
export function liteAtlasBytes({ width, height }: PictureSize): number {
  return LITE_BYTES_PER_PIXEL * Math.max(LEAST_PIXELS, width * height);
}
