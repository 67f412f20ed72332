import { BufferGeometry, Float32BufferAttribute } from 'three';
import type { Vector3Tuple } from '../fields/Field';

/** Where the planes of a grid lie along x, y and z (m); in any order, also twice. */
export type GridPlanes = readonly [x: readonly number[], y: readonly number[], z: readonly number[]];

/** Planes nearer than this are one (m). */
const SAME = 1e-6;

function sorted(planes: readonly number[]): number[] {
  const kept: number[] = [];
  for (const at of planes.toSorted((a, b) => a - b)) if (at - (kept.at(-1) ?? -Infinity) > SAME) kept.push(at);
  return kept;
}

/**
 * The surface of the cells of a grid that are solid: flat faces between solid and empty cells alone, so none inside, and no
 * vertex in the middle of another face's edge. Texture coordinates are metres, as those of `MeshBuilder`.
 *
 * @param planes between which the cells lie
 * @param isSolid whether the cell with this middle is solid
 */
export function solidGrid(planes: GridPlanes, isSolid: (middle: Vector3Tuple) => boolean): BufferGeometry {
  const lines = planes.map(sorted);
  const [nx, ny, nz] = lines.map(({ length }) => Math.max(0, length - 1));
  const middle = (axis: number, i: number): number => (lines[axis][i] + lines[axis][i + 1]) / 2;
  const solid = new Uint8Array(nx * ny * nz);
  const at = (x: number, y: number, z: number): number => (z * ny + y) * nx + x;
  for (let z = 0; z < nz; z++)
    for (let y = 0; y < ny; y++)
      for (let x = 0; x < nx; x++) if (isSolid([middle(0, x), middle(1, y), middle(2, z)])) solid[at(x, y, z)] = 1;
  const counts = [nx, ny, nz];
  const isFull = (cell: readonly number[]): boolean =>
    cell.every((i, axis) => i >= 0 && i < counts[axis]) && solid[at(cell[0], cell[1], cell[2])] === 1;

  const positions: number[] = [];
  const normals: number[] = [];
  const uvs: number[] = [];
  const indices: number[] = [];
  const face = (cell: readonly number[], axis: number, side: -1 | 1): void => {
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    // upright faces have v upwards, so that a texture stands
    const [across, up] = axis === 0 ? [v, u] : [u, v].toSorted((a, b) => a - b);
    const base = positions.length / 3;
    for (const [a, b] of corners) {
      const corner = [0, 0, 0];
      corner[axis] = lines[axis][cell[axis] + (side + 1) / 2];
      corner[u] = lines[u][cell[u] + a];
      corner[v] = lines[v][cell[v] + b];
      positions.push(...corner);
      normals.push(...[0, 1, 2].map((i) => (i === axis ? side : 0)));
      uvs.push(corner[across], corner[up]);
    }
    const [second, fourth] = side === 1 ? [1, 3] : [3, 1];
    indices.push(base, base + second, base + 2, base, base + 2, base + fourth);
  };
  for (let z = 0; z < nz; z++)
    for (let y = 0; y < ny; y++)
      for (let x = 0; x < nx; x++) {
        const cell = [x, y, z];
        if (!isFull(cell)) continue;
        for (let axis = 0; axis < 3; axis++)
          for (const side of [-1, 1] as const)
            if (!isFull(cell.map((i, each) => (each === axis ? i + side : i)))) face(cell, axis, side);
      }

  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new Float32BufferAttribute(normals, 3));
  geometry.setAttribute('uv', new Float32BufferAttribute(uvs, 2));
  geometry.setIndex(indices);
  return geometry;
}

/** Corners of a face, anticlockwise seen from the positive side of its axis. */
const corners = [
  [0, 0],
  [1, 0],
  [1, 1],
  [0, 1],
] as const;
