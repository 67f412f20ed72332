import { Matrix4, type Camera } from 'three';
import type { DataTable } from '../lights/DataTable';
import { FLOATS_PER_RECORD } from '../lights/lightRecord';

/**
 * A mask in the light table: what a shadow map and a cookie let through of a light. Three records of four texels:
 *
 * | texel | holds |
 * |---|---|
 * | 0–3 | columns of the matrix from view space to the map (0 to 1, depth 0 to 1), or to what leads from a point light there (m, world axes) |
 * | 4 | tile of the shadow map (texels): corner, size; of a cube: corner, side of a face, distance from face to face |
 * | 5 | bias (with the sign of the depth buffer), normal bias (m), radius (texels), intensity |
 * | 6 | kind of shadow (`shadowKinds`), size of the map as the light asks for it (texels), kind of cookie (0 none, 1 map, 2 cube) |
 * | 7 | of a cube: a and b of depth = a + b / distance along an axis, nearest and farthest (m) |
 * | 8 | tile of the cookie, as texel 4 |
 * | 9 | layers of the light, 16 bits and 16 bits; –, – |
 */
export const RECORDS_PER_MASK = 3;

/** What a mask does with its shadow map; as in lightShadow.glsl. */
export const shadowKinds = { none: 0, basic: 1, pcf: 2, cubeBasic: 3, cubePcf: 4, vsm: 5 } as const;

const matrix = new Matrix4();

/** Writes texels 0 to 3: a matrix from world space, for positions in view space. */
export function writeMaskMatrix(table: DataTable, record: number, fromWorld: Matrix4, camera: Camera): void {
  const at = record * FLOATS_PER_RECORD;
  const e = matrix.multiplyMatrices(fromWorld, camera.matrixWorld).elements;
  for (let i = 0; i < 16; i += 4) table.set4(at + i, e[i], e[i + 1], e[i + 2], e[i + 3]);
}
