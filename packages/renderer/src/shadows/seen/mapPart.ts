import type { Matrix4 } from 'three';

/**
 * Widens the part of a map so that it holds a box as a camera sees it.
 * @param part least and most across, least and most up, -1 to 1 in the map, 4 numbers
 * @param boxes centre and half sizes (m), 6 numbers from index `at` on
 * @param camera from world to clip space
 */
export function mapPart(part: Float64Array, boxes: Float64Array, at: number, camera: Matrix4): void {
  const e = camera.elements;
  for (let corner = 0; corner < 8; corner++) {
    const x = boxes[at] + ((corner & 1) * 2 - 1) * boxes[at + 3];
    const y = boxes[at + 1] + ((corner & 2) - 1) * boxes[at + 4];
    const z = boxes[at + 2] + (((corner >> 1) & 2) - 1) * boxes[at + 5];
    const w = e[3] * x + e[7] * y + e[11] * z + e[15];
    if (!(w > 1e-6)) {
      // beside or behind the camera: it may be anywhere
      part[0] = part[2] = -Infinity;
      part[1] = part[3] = Infinity;
      return;
    }
    const across = (e[0] * x + e[4] * y + e[8] * z + e[12]) / w;
    const up = (e[1] * x + e[5] * y + e[9] * z + e[13]) / w;
    if (across < part[0]) part[0] = across;
    if (across > part[1]) part[1] = across;
    if (up < part[2]) part[2] = up;
    if (up > part[3]) part[3] = up;
  }
}
