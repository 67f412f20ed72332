import type { Vector2, Vector4 } from 'three';

/** Standard deviation of the weight of a sample off the middle of a cell, in cells. */
const REACH = 0.42;

/**
 * How much a sample counts in each cell of a pixel: the Gaussian of its way to the cell's middle, or whether it lies in it.
 * @param jitter - by which the picture is moved (normalised device coordinates)
 * @param cells - along a pixel's side: 1, where it counts whole, or 2
 * @param strict - count 1 in the cell that the sample lies in and 0 in the others
 * @param out - 0 to 1, rows of cells from the lower left on
 * @see Karis 2014, High Quality Temporal Supersampling
 */
export function cellWeights(
  jitter: Vector2,
  width: number,
  height: number,
  cells: number,
  strict: boolean,
  out: Vector4,
): Vector4 {
  out.set(1, 1, 1, 1);
  if (cells === 1) return out;
  for (let i = 0; i < 4; i++) {
    // samples are moved against the picture; the nearest of them may be a neighbour's
    const x = off(((i & 1) - 0.5) / 2 + (jitter.x * width) / 2);
    const y = off(((i >> 1) - 0.5) / 2 + (jitter.y * height) / 2);
    const inside = Math.abs(x) <= 0.5 && Math.abs(y) <= 0.5;
    out.setComponent(i, strict ? Number(inside) : Math.exp(-(x * x + y * y) / (2 * REACH * REACH)));
  }
  return out;
}

/** From pixels to cells, less whole pixels. */
function off(pixels: number): number {
  return 2 * (pixels - Math.round(pixels));
}
