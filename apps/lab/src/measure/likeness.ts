/** The properties of an ImageData that are compared. */
export interface Picture {
  readonly width: number;
  readonly height: number;
  /** RGBA, one byte each. */
  readonly data: Uint8ClampedArray;
}

/**
 * Peak signal-to-noise ratio of two 8-bit pictures over red, green and blue (dB); null for equal pictures.
 *
 * @throws Error when their sizes differ
 */
export function psnr(a: Picture, b: Picture): number | null {
  if (a.width !== b.width || a.height !== b.height) {
    throw new Error(`Pictures of ${a.width} × ${a.height} and ${b.width} × ${b.height} pixels cannot be compared.`);
  }
  let sum = 0;
  for (let i = 0; i < a.data.length; i++) {
    if (i % 4 !== 3) sum += (a.data[i] - b.data[i]) ** 2;
  }
  return sum === 0 ? null : 10 * Math.log10((255 ** 2 * a.width * a.height * 3) / sum);
}
