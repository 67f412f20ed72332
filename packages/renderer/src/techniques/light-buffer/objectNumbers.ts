/** Largest object number; half floats hold whole numbers exactly up to 2,048. */
const NUMBERS = 2047;
/** Number of texels in each 2 × 2 for transparent layers; the fourth belongs to opaque surfaces. */
export const STIPPLE_LAYERS = 3;

/**
 * Number that marks an object's texels in the thin G-buffer: 1 to 2,047, then from 1 again.
 * @param draw - index of the draw in the frame, from 0
 */
export function objectNumber(draw: number): number {
  return (draw % NUMBERS) + 1;
}

/**
 * Corner of each 2 × 2 texels, 1 to 3, that a transparent layer writes; three overlapping layers have one each.
 * @param layer - index of the transparent layer in the frame, from 0, farthest first
 * @see Kircher and Lawrance 2009, section on alpha polygons
 */
export function stippleCorner(layer: number): number {
  return (layer % STIPPLE_LAYERS) + 1;
}
