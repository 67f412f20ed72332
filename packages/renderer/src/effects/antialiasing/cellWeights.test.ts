import { Vector2, Vector4 } from 'three';
import { expect, it } from 'vitest';
import { cellWeights } from './cellWeights';

const out = new Vector4();
/** Jitter that moves samples by a part of a pixel: against the picture. */
const sampleAt = (x: number, y: number) => new Vector2((-2 * x) / 300, (-2 * y) / 200);
const weights = (x: number, y: number, strict: boolean, cells = 2) =>
  cellWeights(sampleAt(x, y), 300, 200, cells, strict, out).toArray();

it('counts a sample whole in the cell in whose middle it lies, and the less the farther it lies off', () => {
  expect(weights(-0.25, -0.25, false)[0]).toBeCloseTo(1, 10);
  expect(weights(0.25, -0.25, false)[1]).toBeCloseTo(1, 10);
  expect(weights(-0.25, 0.25, false)[2]).toBeCloseTo(1, 10);
  const [left, right] = weights(-0.1, -0.25, false);
  expect(left).toBeGreaterThan(right);
  expect(right).toBeGreaterThan(0.1);
});

it('strictly counts each sample in one cell, over the whole pixel, and gives all four as much', () => {
  const sum = [0, 0, 0, 0];
  for (let x = 0; x < 8; x++) {
    for (let y = 0; y < 8; y++) {
      weights((x + 0.5) / 8 - 0.5, (y + 0.5) / 8 - 0.5, true).forEach((weight, i) => (sum[i] += weight));
    }
  }
  expect(sum).toEqual([16, 16, 16, 16]);
});

it('counts the nearest sample, although it may be a neighbour pixel’s', () => {
  expect(weights(0.5, 0.25, false)[2]).toBeCloseTo(weights(0.5, 0.25, false)[3], 10);
});

it('counts every sample whole in a cell that is a pixel', () => {
  expect(weights(0.4, -0.3, false, 1)).toEqual([1, 1, 1, 1]);
});
