import { describe, expect, it } from 'vitest';
import { fitCells, lightBoxes, mostLightsPerCell } from './fitCells';

/** Boxes of `count` spheres of radius 2 m at random places in a cube. */
function randomBoxes(count: number, side: number): Float32Array {
  let seed = 5;
  const random = (): number => (seed = (seed * 16807) % 2147483647) / 2147483647;
  const positions = Float32Array.from({ length: count * 3 }, () => (random() - 0.5) * side);
  const points = { count, positions, colours: new Float32Array(count * 3), ranges: new Float32Array(count).fill(2) };
  return lightBoxes({ points, spots: [] });
}

/** Number of lights in the fullest cell, by PlayCanvas's rule, of a grid over the lights' bounds. */
function fullest(boxes: Float32Array, size: readonly number[]): number {
  const bound = (k: number, pick: (...values: number[]) => number): number =>
    pick(...Array.from({ length: boxes.length / 6 }, (_, i) => boxes[i * 6 + k]));
  const min = [0, 1, 2].map((k) => bound(k, Math.min));
  const max = [3, 4, 5].map((k) => bound(k, Math.max));
  const counts = new Map<string, number>();
  for (let i = 0; i < boxes.length; i += 6) {
    const range = [0, 1, 2].map((k) => {
      const scale = size[k] / (max[k] - min[k]);
      const from = Math.max(0, Math.floor((boxes[i + k] - min[k]) * scale));
      return [from, Math.min(size[k] - 1, Math.ceil((boxes[i + 3 + k] - min[k]) * scale))];
    });
    for (let x = range[0][0]; x <= range[0][1]; x++)
      for (let y = range[1][0]; y <= range[1][1]; y++)
        for (let z = range[2][0]; z <= range[2][1]; z++) {
          const key = `${x} ${y} ${z}`;
          counts.set(key, (counts.get(key) ?? 0) + 1);
        }
  }
  return Math.max(...counts.values());
}

describe('the grid of cells', () => {
  it.each([
    [1, 1],
    [10, 20],
    [400, 20],
    [900, 20],
  ])('holds %i lights in a cube of %i m without one too many', (count, side) => {
    const boxes = randomBoxes(count, side);
    const cells = fitCells(boxes);
    expect(cells.fullest).toBe(fullest(boxes, cells.size));
    expect(cells.fullest).toBeLessThanOrEqual(mostLightsPerCell);
  });

  it('has wide cells for few lights and narrower ones for a crowd', () => {
    const volume = ({ size }: { size: readonly number[] }): number => size[0] * size[1] * size[2];
    expect(volume(fitCells(randomBoxes(3000, 12)))).toBeGreaterThan(volume(fitCells(randomBoxes(100, 12))));
  });

  it.each([
    [3000, 0.01],
    [4000, 3],
  ])('gives up with %i lights in a cube of %d m, before the lists take more than 64 MB', (count, side) => {
    const { fullest: most, size } = fitCells(randomBoxes(count, side));
    expect(most).toBeGreaterThan(mostLightsPerCell);
    expect(size[0] * size[1] * size[2] * mostLightsPerCell).toBeLessThanOrEqual(2 ** 25);
  });
});
