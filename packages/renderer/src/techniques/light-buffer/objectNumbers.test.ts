import { DataUtils } from 'three';
import { describe, expect, it } from 'vitest';
import { objectNumber, STIPPLE_LAYERS, stippleCorner } from './objectNumbers';

describe('object numbers', () => {
  it('are whole, exact in half floats, never 0, and different for 2,047 draws in a row', () => {
    for (const first of [0, 1000, 5000]) {
      const numbers = Array.from({ length: 2047 }, (_, i) => objectNumber(first + i));
      expect(new Set(numbers).size).toBe(2047);
      for (const number of numbers) {
        expect(number).toBeGreaterThanOrEqual(1);
        expect(DataUtils.fromHalfFloat(DataUtils.toHalfFloat(number))).toBe(number);
      }
    }
  });
});

describe('stipple corners', () => {
  it('leave corner 0 to what is opaque, and differ for as many layers in a row as there are others', () => {
    for (let layer = 0; layer < 20; layer++) {
      const corners = Array.from({ length: STIPPLE_LAYERS }, (_, i) => stippleCorner(layer + i));
      expect(corners.toSorted()).toEqual([1, 2, 3]);
    }
  });
});
