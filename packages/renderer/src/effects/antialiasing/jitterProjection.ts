import type { Matrix4 } from 'three';

/**
 * Moves a projection by normalised device coordinates: a row operation, right for perspective, orthographic and off-centre
 * projections alike.
 */
export function jitterProjection(projection: Matrix4, x: number, y: number): Matrix4 {
  const e = projection.elements;
  for (let column = 0; column < 16; column += 4) {
    e[column] += x * e[column + 3];
    e[column + 1] += y * e[column + 3];
  }
  return projection;
}
