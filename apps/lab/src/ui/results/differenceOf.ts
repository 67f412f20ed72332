/** Factor by which differences are brightened. */
export const GAIN = 8;

/**
 * Absolute difference of two 8-bit pictures, {@link GAIN} times brighter.
 *
 * @returns null if their sizes differ
 */
export function differenceOf(a: ImageData, b: ImageData): ImageData | null {
  if (a.width !== b.width || a.height !== b.height) return null;
  const made = new ImageData(a.width, a.height);
  for (let i = 0; i < made.data.length; i++) {
    made.data[i] = i % 4 === 3 ? 255 : Math.abs(a.data[i] - b.data[i]) * GAIN;
  }
  return made;
}
