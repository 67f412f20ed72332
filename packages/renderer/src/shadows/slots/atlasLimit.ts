import type { PictureSize } from '../../lights/PictureSize';
import type { ShadowSlot } from './ShadowSlot';

/** Texels a pixel of the picture that the maps of lights with a range have at most: fewer would show, see docs/performance.md. */
const TEXELS_PER_PIXEL = 48;
/** Pixels that a picture is taken to have at least. */
const LEAST_PIXELS = 1280 * 720;
/** Texels a side of the largest atlas. */
const LARGEST = 8192;
/** Texels a side from one size to the next. */
const STEP = 256;

type Asking = Pick<ShadowSlot, 'range' | 'isCube' | 'side' | 'wantedWidth' | 'wantedHeight'>;

/**
 * Texels a side that the atlas of shadow maps grows to at most for a picture: where lights ask for more, the maps of those that
 * cover least of it are halved. The atlas has room for what lights without a range ask for on top of that.
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
