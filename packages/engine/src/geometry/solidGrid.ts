import type { Vector3Tuple } from '@farol/editing/fields';
import { BufferAttribute, BufferGeometry } from 'three';

/** Positions of a grid's planes along x, y and z (m); in any order, repeats allowed. */
export type GridPlanes = readonly [x: readonly number[], y: readonly number[], z: readonly number[]];

/** Planes at most this far apart count as one (m). */
const SAME = 1e-6;

function sorted(planes: readonly number[]): number[] {
  const kept: number[] = [];
  for (const at of planes.toSorted((a, b) => a - b)) if (at - (kept.at(-1) ?? -Infinity) > SAME) kept.push(at);
  return kept;
}

/**
 * Surface of the solid cells of a grid: flat faces only between solid and empty cells, and no vertex in the middle of
 * another face's edge. Texture coordinates are in metres, as in `MeshBuilder`.
 *
 * @param planes - planes that bound the cells
 * @param isSolid - returns whether the cell with this centre is solid
 */
export function solidGrid(planes: GridPlanes, isSolid: (middle: Vector3Tuple) => boolean): BufferGeometry {
  const lines = planes.map(sorted);
  const [nx, ny, nz] = lines.map(({ length }) => Math.max(0, length - 1));
  const middle = (axis: number, i: number): number => (lines[axis][i] + lines[axis][i + 1]) / 2;
  const solid = new Uint8Array(nx * ny * nz);
  const counts = [nx, ny, nz];
  const strides = [1, nx, nx * ny];
  for (let z = 0, at = 0; z < nz; z++)
    for (let y = 0; y < ny; y++)
      for (let x = 0; x < nx; x++, at++) if (isSolid([middle(0, x), middle(1, y), middle(2, z)])) solid[at] = 1;

  /** Visits each face between a solid and an empty cell. */
  const eachFace = (visit: (cell: Vector3Tuple, axis: number, side: -1 | 1) => void): void => {
    for (let at = 0; at < solid.length; at++) {
      if (solid[at] === 0) continue;
      const cell = [at % nx, Math.floor(at / nx) % ny, Math.floor(at / strides[2])] as const;
      for (let axis = 0; axis < 3; axis++) {
        if (cell[axis] === 0 || solid[at - strides[axis]] === 0) visit(cell, axis, -1);
        if (cell[axis] === counts[axis] - 1 || solid[at + strides[axis]] === 0) visit(cell, axis, 1);
      }
    }
  };
  let faces = 0;
  eachFace(() => faces++);
  const positions = new Float32Array(faces * 12);
  const normals = new Float32Array(faces * 12);
  const uvs = new Float32Array(faces * 8);
  const indices = new (faces * 4 > 65_535 ? Uint32Array : Uint16Array)(faces * 6);
  let made = 0;
  eachFace((cell, axis, side) => {
    const u = (axis + 1) % 3;
    const v = (axis + 2) % 3;
    // v points up on upright faces, so that textures are upright
    const across = axis === 0 ? v : Math.min(u, v);
    const up = axis === 0 ? u : Math.max(u, v);
    const base = made * 4;
    for (let corner = 0; corner < 4; corner++) {
      const [a, b] = corners[corner];
      const at = (base + corner) * 3;
      positions[at + axis] = lines[axis][cell[axis] + (side + 1) / 2];
      positions[at + u] = lines[u][cell[u] + a];
      positions[at + v] = lines[v][cell[v] + b];
      normals[at + axis] = side;
      uvs[(base + corner) * 2] = positions[at + across];
      uvs[(base + corner) * 2 + 1] = positions[at + up];
    }
    const second = base + (side === 1 ? 1 : 3);
    const fourth = base + (side === 1 ? 3 : 1);
    indices.set([base, second, base + 2, base, base + 2, fourth], made * 6);
    made++;
  });

  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(normals, 3));
  geometry.setAttribute('uv', new BufferAttribute(uvs, 2));
  geometry.setIndex(new BufferAttribute(indices, 1));
  return geometry;
}

/** Corners of a face, anticlockwise seen from the positive side of its axis. */
const corners = [
  [0, 0],
  [1, 0],
  [1, 1],
  [0, 1],
] as const;
