import type { Vector4 } from 'three';

/** Side (texels) of a buffer with `scale` (above 0, at most 1) texels for each of `pixels`. */
export function gridTexels(pixels: number, scale: number): number {
  return Math.max(1, Math.ceil(pixels * scale));
}

/**
 * Shift of a picture (pixels, 0 to 1) by which texel centres of a smaller buffer fall on pixel centres: at half the
 * resolution a texel's centre would lie between four pixels, and every pixel would be interpolated.
 */
export function gridShift(scale: number): number {
  return (0.5 / scale - 0.5) % 1;
}

/**
 * Transform from the picture's normalised device coordinates to the buffer's: times xy, plus zw. A texel is exactly 1 / `scale`
 * pixels wide, even if the buffer then extends past the picture's edge.
 */
export function gridFit(width: number, height: number, scale: number, out: Vector4): Vector4 {
  const columns = gridTexels(width, scale);
  const rows = gridTexels(height, scale);
  const x = (width * scale) / columns;
  const y = (height * scale) / rows;
  const shift = 2 * gridShift(scale) * scale;
  return out.set(x, y, x - 1 + shift / columns, y - 1 + shift / rows);
}
