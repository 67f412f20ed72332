/** Pixels of a picture that the viewer asks a device for: a screen of 7,680 × 4,320. A technique needs some 40 bytes each. */
const MOST_PIXELS = 7680 * 4320;

const integer = new Intl.NumberFormat('en', { maximumFractionDigits: 0 });

/**
 * The pixel ratio at which a picture can be drawn.
 * @param width - CSS pixels
 * @param height - CSS pixels
 * @param dpr - device pixels a CSS pixel, as asked for
 * @param side - most pixels a side that the device draws
 * @returns the ratio, `dpr` at most, and what to say when it is less; '' for nothing
 */
export function fitSize(width: number, height: number, dpr: number, side: number): { dpr: number; problem: string } {
  const fits = Math.min(dpr, side / width, side / height, Math.sqrt(MOST_PIXELS / (width * height)));
  if (fits >= dpr) return { dpr, problem: '' };
  const size = (ratio: number): string => `${integer.format(width * ratio)} × ${integer.format(height * ratio)}`;
  const problem =
    `The picture would have ${size(dpr)} pixels. It is drawn with ${size(fits)}: this device draws ` +
    `${integer.format(side)} a side, and the viewer ${integer.format(MOST_PIXELS / 1e6)} million in all.`;
  return { dpr: fits, problem };
}
