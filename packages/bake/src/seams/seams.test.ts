import { BoxGeometry, type BufferGeometry, CylinderGeometry, SphereGeometry } from 'three';
import { describe, expect, it } from 'vitest';
import createXAtlas from 'xatlas-wasm';
import { cutCharts } from '../unwrap/cutCharts';
import { packMeshes } from '../unwrap/packMeshes';
import type { SurfaceToUnwrap, UnwrappedMesh } from '../unwrap/UnwrapRequest';
import { findSeams } from './findSeams';
import { stitchLightmap } from './stitchLightmap';

const SIZE = 128;
const xatlas = await createXAtlas();

function unwrap(geometry: BufferGeometry): { surface: SurfaceToUnwrap; unwrapped: UnwrappedMesh } {
  const surface = {
    positions: geometry.getAttribute('position').array as Float32Array,
    normals: geometry.getAttribute('normal').array as Float32Array,
    index: Uint32Array.from(geometry.index!.array),
  };
  const options = { size: SIZE, padding: 3, texelsPerMetre: null };
  const { meshes } = packMeshes([cutCharts(xatlas, surface)], options, () => {});
  return { surface, unwrapped: meshes[0] };
}

/** Smooth light with 10% noise at each texel that a chart touches, as in a bake; 0.3 elsewhere. */
function bake({ positions }: SurfaceToUnwrap, { uv1, index, sourceVertex }: UnwrappedMesh): Float32Array {
  const data = new Float32Array(4 * SIZE * SIZE).fill(0.3);
  for (let i = 0; i < index.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => [uv1[2 * index[i + k]] * SIZE, uv1[2 * index[i + k] + 1] * SIZE]);
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (Math.abs(area) < 1e-9) continue;
    const [left, right] = [Math.min(a[0], b[0], c[0]) - 1, Math.max(a[0], b[0], c[0]) + 1];
    const [bottom, top] = [Math.min(a[1], b[1], c[1]) - 1, Math.max(a[1], b[1], c[1]) + 1];
    for (let y = Math.floor(bottom); y <= top; y++) {
      for (let x = Math.floor(left); x <= right; x++) {
        const [px, py] = [x + 0.5, y + 0.5];
        const v = ((px - a[0]) * (c[1] - a[1]) - (py - a[1]) * (c[0] - a[0])) / area;
        const w = ((b[0] - a[0]) * (py - a[1]) - (b[1] - a[1]) * (px - a[0])) / area;
        const reach = 1.5 / Math.sqrt(Math.abs(area));
        if (Math.min(v, w, 1 - v - w) < -reach) continue;
        const height = [1 - v - w, v, w].reduce(
          (sum, share, k) => sum + share * positions[3 * sourceVertex[index[i + k]] + 1],
          0,
        );
        const at = 4 * (y * SIZE + x);
        const noise = 0.1 * Math.sin(12.9898 * x + 78.233 * y);
        if (at >= 0 && at < data.length) data.fill((1 + 0.5 * height) * (1 + noise), at, at + 4);
      }
    }
  }
  return data;
}

/** Bilinear sample of `data` at u, v. */
function sample(data: Float32Array, u: number, v: number): number {
  const [x, y] = [u * SIZE - 0.5, v * SIZE - 0.5];
  const [column, row] = [Math.floor(x), Math.floor(y)];
  let sum = 0;
  for (const [i, j] of [0, 1, 2, 3].map((k) => [k & 1, k >> 1])) {
    const weight = (i === 0 ? 1 - (x - column) : x - column) * (j === 0 ? 1 - (y - row) : y - row);
    const [x0, y0] = [column + i, row + j].map((texel) => Math.min(Math.max(texel, 0), SIZE - 1));
    sum += weight * data[4 * (y0 * SIZE + x0)];
  }
  return sum;
}

/** Root mean square of the light's step across seams, at points between the solver's samples. */
function stepAcross(data: Float32Array, { uv1 }: UnwrappedMesh, seams: Uint32Array): number {
  let [sum, count] = [0, 0];
  for (let i = 0; i < seams.length; i += 4) {
    for (const t of [0.137, 0.409, 0.641, 0.883]) {
      const at = (from: number, to: number): number =>
        sample(
          data,
          uv1[2 * from] + t * (uv1[2 * to] - uv1[2 * from]),
          uv1[2 * from + 1] + t * (uv1[2 * to + 1] - uv1[2 * from + 1]),
        );
      sum += (at(seams[i], seams[i + 1]) - at(seams[i + 2], seams[i + 3])) ** 2;
      count++;
    }
  }
  return Math.sqrt(sum / count);
}

describe('stitchLightmap', () => {
  it.each([
    ['sphere', new SphereGeometry(1, 32, 16)],
    ['cylinder', new CylinderGeometry(0.5, 0.5, 2, 32, 4, true)],
  ])('makes light meet across the seams of a %s, and leaves it else as it was', (_, geometry) => {
    const { surface, unwrapped } = unwrap(geometry);
    const seams = findSeams(surface, unwrapped);
    expect(seams.length).toBeGreaterThan(4 * 3);
    const before = bake(surface, unwrapped);
    const after = stitchLightmap({ size: SIZE, data: before.slice(), meshes: [{ surface, unwrapped }] });
    const [step, left] = [before, after].map((data) => stepAcross(data, unwrapped, seams));
    expect(step).toBeGreaterThan(0.05);
    expect(left).toBeLessThan(step / 8);
    const changes = after.map((value, i) => Math.abs(value - before[i]));
    expect(Math.max(...changes)).toBeLessThan(0.5);
    expect(changes.reduce((sum, value) => sum + value) / before.length).toBeLessThan(0.01);
    for (let i = 3; i < before.length; i += 4) expect(after[i]).toBe(before[i]);
  });

  it('takes an edge for a seam where it is smooth at both ends, by its normals or its faces', () => {
    // two triangles with a common edge, in separate charts
    const positions = Float32Array.of(
      ...[0, 0, 0],
      ...[0, 1, 0],
      ...[1, 0, 0],
      ...[0, 0, 0],
      ...[0, 1, 0],
      ...[-1, 0, 0],
    );
    const index = Uint32Array.of(0, 2, 1, 3, 4, 5);
    const uv1 = Float32Array.of(0, 0, 0, 0.4, 0.4, 0, 0.6, 0, 0.6, 0.4, 1, 0);
    const sourceVertex = Uint32Array.of(0, 1, 2, 3, 4, 5);
    const [front, side] = [
      [0, 0, 1],
      [1, 0, 0],
    ];
    const seamsBy = (low: number[], high: number[]): number => {
      const normals = Float32Array.of(...front, ...front, ...front, ...low, ...high, ...front);
      return findSeams({ positions, normals, index }, { uv1, index, sourceVertex }).length / 4;
    };
    expect([seamsBy(front, front), seamsBy(side, front), seamsBy(front, side), seamsBy(side, side)]).toEqual([
      1, 0, 0, 0,
    ]);
    const seamsOf = (z: number): number => {
      const bent = positions.slice();
      bent[17] = z;
      return findSeams({ positions: bent, normals: null, index }, { uv1, index, sourceVertex }).length / 4;
    };
    expect([seamsOf(0), seamsOf(0.2), seamsOf(1)]).toEqual([1, 1, 0]);
  });

  it('leaves hard edges alone, where light may differ', () => {
    const { surface, unwrapped } = unwrap(new BoxGeometry());
    expect(findSeams(surface, unwrapped)).toHaveLength(0);
    const before = bake(surface, unwrapped);
    expect(stitchLightmap({ size: SIZE, data: before.slice(), meshes: [{ surface, unwrapped }] })).toEqual(before);
  });
});
