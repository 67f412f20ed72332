import { FACES } from './cubeFaceParts';

/**
 * Which faces of a cube map round a point may see some of a box in the part of them that is drawn.
 * @param faces in question, bits 0 to 5 for +x, -x, +y, -y, +z, -z
 * @param parts of the six faces: least and most across, least and most up, as parts of the axis (-1 to 1 in a face), 4 numbers each
 * @param boxes centre and half sizes (m), 6 numbers from index `at` on
 * @returns those of the faces; one that sees nothing of the box there may be among them, not the other way round
 */
export function cubeFacesDrawn(
  faces: number,
  parts: Float64Array,
  boxes: Float64Array,
  at: number,
  x: number,
  y: number,
  z: number,
): number {
  let seen = faces;
  for (let i = 0; i < 6; i++) {
    if ((faces & (1 << i)) === 0) continue;
    const face = i * 6;
    const axis = FACES[face];
    const right = FACES[face + 2];
    const top = FACES[face + 4];
    const along = FACES[face + 1] * (boxes[at + axis] - (axis === 0 ? x : axis === 1 ? y : z));
    const across = FACES[face + 3] * (boxes[at + right] - (right === 0 ? x : right === 1 ? y : z));
    const up = FACES[face + 5] * (boxes[at + top] - (top === 0 ? x : top === 1 ? y : z));
    const deep = boxes[at + 3 + axis];
    const wide = boxes[at + 3 + right];
    const high = boxes[at + 3 + top];
    const part = i * 4;
    const inside =
      across + wide >= parts[part] * along - Math.abs(parts[part]) * deep &&
      across - wide <= parts[part + 1] * along + Math.abs(parts[part + 1]) * deep &&
      up + high >= parts[part + 2] * along - Math.abs(parts[part + 2]) * deep &&
      up - high <= parts[part + 3] * along + Math.abs(parts[part + 3]) * deep;
    if (!inside) seen &= ~(1 << i);
  }
  return seen;
}
