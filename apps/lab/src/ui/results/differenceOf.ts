/** How much brighter differences are shown than they are. */
export const GAIN = 8;

/**
 * Where two 8-bit pictures differ: their absolute difference, {@link GAIN} times brighter.
 *
 * @returns null where their sizes differ
 */
export function differenceOf(a: ImageData, b: ImageData): ImageData | null {
  if (a.width !== b.width || a.height !== b.height) return null;
  const made = new ImageData(a.width, a.height);
  for (let i = 0; i < made.data.length; i++) {
    made.data[i] = i % 4 === 3 ? 255 : Math.abs(a.data[i] - b.data[i]) * GAIN;
  }
  return made;
}
