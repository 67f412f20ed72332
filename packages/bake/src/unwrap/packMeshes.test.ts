import { expect, test } from 'vitest';
import type { Charts } from './cutCharts';
import { packMeshes } from './packMeshes';

/** Charts of one surface: rectangles side by side, with sides in metres. */
function rectangles(sides: readonly (readonly [number, number])[]): Charts {
  const uvs: number[] = [];
  const index: number[] = [];
  const charts: number[] = [];
  sides.forEach(([width, height], i) => {
    uvs.push(20 * i, 0, 20 * i + width, 0, 20 * i + width, height, 20 * i, height);
    index.push(...[0, 1, 2, 0, 2, 3].map((k) => 4 * i + k));
    charts.push(i, i);
  });
  return {
    area: sides.reduce((sum, [width, height]) => sum + width * height, 0),
    uvs: Float32Array.from(uvs),
    index: Uint32Array.from(index),
    sourceVertex: Uint32Array.from({ length: uvs.length / 2 }, (_, i) => i),
    charts: Uint32Array.from(charts),
  };
}

/** Bounds of each rectangle in texels. */
const boundsOf = (uv1: Float32Array, size: number): number[][] =>
  Array.from({ length: uv1.length / 8 }, (_, i) => {
    const corners = Array.from(uv1.subarray(8 * i, 8 * i + 8), (value) => value * size);
    const [us, vs] = [0, 1].map((axis) => corners.filter((_, k) => k % 2 === axis));
    return [Math.min(...us), Math.min(...vs), Math.max(...us), Math.max(...vs)];
  });

test('charts begin and end at centres of texels, with the padding between them, and leave little room', () => {
  const sides = Array.from({ length: 60 }, (_, i) => [1 + (i % 7), 1 + ((i * 5) % 11)] as const);
  const size = 256;
  const packed = packMeshes([rectangles(sides)], { size, padding: 3, texelsPerMetre: null }, () => {});
  const bounds = boundsOf(packed.meshes[0].uv1, size);
  let covered = 0;
  bounds.forEach(([left, bottom, right, top], i) => {
    for (const side of [left, bottom, right, top]) expect(Math.abs((side % 1) - 0.5)).toBeLessThan(1e-3);
    expect(Math.min(left, bottom)).toBeGreaterThan(0);
    expect(Math.max(right, top)).toBeLessThan(size);
    covered += (right - left) * (top - bottom);
    bounds.slice(0, i).forEach((other) => {
      // gap in texels between two rectangles
      const between = Math.max(left - other[2], other[0] - right, bottom - other[3], other[1] - top);
      expect(between).toBeGreaterThan(3.999);
    });
  });
  expect(covered / size ** 2).toBeGreaterThan(0.55);
});

test('a lightmap that is too small for its charts is refused at once, with what to do', () => {
  const sides = Array.from({ length: 2000 }, () => [1, 1] as const);
  expect(() => packMeshes([rectangles(sides)], { size: 64, padding: 4, texelsPerMetre: null }, () => {})).toThrow(
    /64 texels is too small for 2000 charts: choose a larger size/,
  );
});
