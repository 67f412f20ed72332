import type { Vector2, Vector4 } from 'three';

/** Standard deviation of the Gaussian that weighs a sample by its distance to a cell's middle (cells). */
const REACH = 0.42;

/**
 * Weight of a sample in each cell of a pixel: a Gaussian of its distance to the cell's middle, or 1 in its own cell alone.
 * @param jitter - shift of the picture (normalised device coordinates)
 * @param cells - cells along a pixel's side: 1 (the weight is 1) or 2
 * @param strict - whether the weight is 1 in the sample's own cell and 0 in others
 * @param out - receives weights, 0 to 1, in rows from the lower left
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
    // jitter shifts the samples; the nearest one may be a neighbouring pixel's
    const x = off(((i & 1) - 0.5) / 2 + (jitter.x * width) / 2);
    const y = off(((i >> 1) - 0.5) / 2 + (jitter.y * height) / 2);
    const inside = Math.abs(x) <= 0.5 && Math.abs(y) <= 0.5;
    out.setComponent(i, strict ? Number(inside) : Math.exp(-(x * x + y * y) / (2 * REACH * REACH)));
  }
  return out;
}

/** Offset of a position (pixels) within its pixel, in history cells. */
function off(pixels: number): number {
  return 2 * (pixels - Math.round(pixels));
}
