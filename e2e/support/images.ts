/** An image of linear floats. */
export interface FloatImage {
  width: number;
  height: number;
  /** [height, width, 4], linear RGBA, bottom row first. */
  data: ArrayLike<number>;
}

/** Error of a byte that was kept as a linear float of 32 bits (1/255): two whole steps are no more than two. */
const ROUNDING = 1e-4;

/** How far two images are apart. */
export interface Difference {
  /** Largest absolute difference of a linear channel. Infinity where one alone is infinite, or one is not a number. */
  largest: number;
  /** Peak signal-to-noise ratio after sRGB encoding, peak 1 (dB); Infinity when equal. */
  psnr: number;
  /** Share of pixels, 0 to 1, with a channel off by more than `steps`/255 after sRGB encoding, or alpha by as much. */
  share: number;
  /** Largest absolute difference of alpha. Infinity as in `largest`. */
  alpha: number;
}

/** A difference in words, for messages. */
export function figuresOf({ largest, psnr, share, alpha }: Difference): string {
  const off = `${(share * 100).toFixed(3)}% off by more than 2/255`;
  return `largest ${largest.toExponential(2)}, ${psnr.toFixed(1)} dB, ${off}, alpha ${alpha.toExponential(2)}`;
}

/** The sRGB transfer function, input clamped to 0..1. @see IEC 61966-2-1 */
export function encodeSRGB(linear: number): number {
  if (!(linear > 0)) return 0;
  if (linear >= 1) return 1;
  return linear <= 0.0031308 ? linear * 12.92 : 1.055 * linear ** (1 / 2.4) - 0.055;
}

/**
 * Compares red, green and blue of two images, and alpha by figures of its own.
 *
 * @param steps - how many 1/255 a pixel may be off before it counts in `share`; default 2
 * @throws RangeError when the sizes differ
 */
export function compareImages(a: FloatImage, b: FloatImage, steps = 2): Difference {
  if (a.width !== b.width || a.height !== b.height || a.data.length !== b.data.length) {
    throw new RangeError(`Images of ${a.width}×${a.height} and ${b.width}×${b.height} cannot be compared.`);
  }
  let largest = 0;
  let alpha = 0;
  let squares = 0;
  let off = 0;
  for (let pixel = 0; pixel < a.data.length; pixel += 4) {
    let worst = 0;
    for (let channel = pixel; channel < pixel + 3; channel++) {
      const linear = distance(a.data[channel], b.data[channel]);
      if (linear === 0) continue;
      largest = Math.max(largest, linear);
      const encoded = Math.abs(encodeSRGB(a.data[channel]) - encodeSRGB(b.data[channel]));
      squares += encoded * encoded;
      worst = Math.max(worst, linear === Infinity ? Infinity : encoded);
    }
    const difference = distance(a.data[pixel + 3], b.data[pixel + 3]);
    alpha = Math.max(alpha, difference);
    if (Math.max(worst, difference) > (steps + ROUNDING) / 255) off++;
  }
  const pixels = a.data.length / 4;
  const psnr = squares === 0 ? Infinity : -10 * Math.log10(squares / (pixels * 3));
  return { largest, psnr, share: off / pixels, alpha };
}

/** Infinite in both is no difference: light beyond what the shader or target can hold, in stock three's picture too. */
function distance(a: number, b: number): number {
  if (a === b) return 0;
  const difference = Math.abs(a - b);
  return Number.isNaN(difference) ? Infinity : difference;
}

/**
 * Whether an image shows nothing: all of its pixels are within `tolerance` of each other, or one is not finite.
 *
 * @param tolerance - linear; default 1/512
 */
export function isFlat(image: FloatImage, tolerance = 1 / 512): boolean {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let pixel = 0; pixel < image.data.length; pixel += 4) {
    for (let channel = 0; channel < 3; channel++) {
      const value = image.data[pixel + channel];
      if (!Number.isFinite(value)) return true;
      low[channel] = Math.min(low[channel], value);
      high[channel] = Math.max(high[channel], value);
    }
  }
  return low.every((value, channel) => high[channel] - value <= tolerance);
}
