import type { RivalScene } from '../../../src/competitors/rivals/RivalScene';

/** Bounding boxes of lights: [n, 6], minimum then maximum x, y, z. */
export type LightBoxes = Float32Array;

export interface Cells {
  /** Number of cells along x, y, z. */
  readonly size: readonly [x: number, y: number, z: number];
  /** Number of lights in the fullest cell, by PlayCanvas's rule. */
  readonly fullest: number;
}

/** Maximum number of lights of a cell: PlayCanvas counts them in a byte. */
export const mostLightsPerCell = 255;
/** Maximum number of entries of all cells' lists: 64 MB of 16-bit indices. */
const mostEntries = 2 ** 25;

/** Bounding boxes of the point and spot lights of a scene, at their current places. */
export function lightBoxes({ points, spots }: Pick<RivalScene, 'points' | 'spots'>): LightBoxes {
  const boxes = new Float32Array((points.count + spots.length) * 6);
  const put = (i: number, position: ArrayLike<number>, at: number, range: number): void => {
    for (let k = 0; k < 3; k++) {
      boxes[i * 6 + k] = position[at + k] - range;
      boxes[i * 6 + 3 + k] = position[at + k] + range;
    }
  };
  for (let i = 0; i < points.count; i++) put(i, points.positions, i * 3, points.ranges[i]);
  // bounds of the range's sphere, never smaller than PlayCanvas's box of the cone
  spots.forEach(({ position, range }, i) => put(points.count + i, position, 0, range));
  return boxes;
}

/** Grid of cells of a width (m), and the number of lights in its fullest cell. */
function cellsOf(boxes: LightBoxes, width: number): Cells {
  const [min, max] = [
    [Infinity, Infinity, Infinity],
    [-Infinity, -Infinity, -Infinity],
  ];
  for (let i = 0; i < boxes.length; i++) {
    const k = i % 6;
    if (k < 3) min[k] = Math.min(min[k], boxes[i]);
    else max[k - 3] = Math.max(max[k - 3], boxes[i]);
  }
  const size = [0, 1, 2].map((k) => Math.max(1, Math.ceil((max[k] - min[k]) / width))) as [number, number, number];
  const counts = new Int32Array(size[0] * size[1] * size[2]);
  const [from, to] = [new Int32Array(3), new Int32Array(3)];
  for (let i = 0; i < boxes.length; i += 6) {
    for (let k = 0; k < 3; k++) {
      const scale = size[k] / (max[k] - min[k]);
      from[k] = Math.max(0, Math.floor((boxes[i + k] - min[k]) * scale));
      to[k] = Math.min(size[k] - 1, Math.ceil((boxes[i + 3 + k] - min[k]) * scale));
    }
    for (let x = from[0]; x <= to[0]; x++) {
      for (let z = from[2]; z <= to[2]; z++) {
        for (let y = from[1]; y <= to[1]; y++) counts[x + size[0] * (z + y * size[2])]++;
      }
    }
  }
  return { size, fullest: counts.reduce((a, b) => Math.max(a, b), 0) };
}

/**
 * Finds a grid of cells a third of the median light's range wide; narrower while a cell would overflow, until the lists
 * of all cells take 64 MB.
 * @param boxes - bounding boxes of at least one light
 */
export function fitCells(boxes: LightBoxes): Cells {
  const reaches = Array.from({ length: boxes.length / 6 }, (_, i) => (boxes[i * 6 + 3] - boxes[i * 6]) / 2);
  reaches.sort((a, b) => a - b);
  let width = reaches[reaches.length >> 1] / 3;
  let cells = cellsOf(boxes, width);
  // leaves space for lights that move between cells
  while (cells.fullest * 1.1 > mostLightsPerCell - 8) {
    width *= 0.8;
    const narrower = cellsOf(boxes, width);
    const isTooLarge = narrower.size[0] * narrower.size[1] * narrower.size[2] * mostLightsPerCell > mostEntries;
    // lights at one place are in one cell, however narrow
    if (isTooLarge || narrower.fullest === boxes.length / 6) break;
    cells = narrower;
  }
  return cells;
}
