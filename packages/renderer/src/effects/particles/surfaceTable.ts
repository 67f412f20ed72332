import { Matrix4, Vector3, type Mesh } from 'three';
import { hasReadableVertices, isReadable } from '../../three/vertexData';

/** Texels of a triangle: three corners, two of them with `share` and `alias` of `aliasTable`, then their normals. */
export const TEXELS_PER_TRIANGLE = 6;

/** Table from which a triangle of a surface is chosen in proportion to its area, by two random numbers (alias method). */
export interface SurfaceTable {
  /** Texels of each triangle, 4 × TEXELS_PER_TRIANGLE floats, in the mesh's space. */
  readonly data: Float32Array;
  readonly triangles: number;
}

const corners = [new Vector3(), new Vector3(), new Vector3()] as const;
const placed = [new Vector3(), new Vector3(), new Vector3()] as const;
const edge = new Vector3();
const normal = new Vector3();

/**
 * Vose's alias method: `i` is chosen uniformly, then kept with probability `share[i]`, else replaced by `alias[i]`.
 * @param weights - each at least 0, with a sum above 0
 * @see Vose 1991, A Linear Algorithm for Generating Random Numbers with a Given Distribution
 */
export function aliasTable(weights: Float64Array): { share: Float64Array; alias: Uint32Array } {
  const { length } = weights;
  const sum = weights.reduce((a, b) => a + b, 0);
  const share = weights.map((weight) => (weight * length) / sum);
  const alias = Uint32Array.from(share, (_, i) => i);
  const small: number[] = [];
  const large: number[] = [];
  share.forEach((each, i) => (each < 1 ? small : large).push(i));
  while (small.length > 0 && large.length > 0) {
    const less = small.pop()!;
    const more = large[large.length - 1];
    alias[less] = more;
    share[more] -= 1 - share[less];
    if (share[more] < 1) {
      large.pop();
      small.push(more);
    }
  }
  // entries left over by rounding have a share of 1
  for (const i of [...small, ...large]) share[i] = 1;
  return { share, alias };
}

type Attribute = Mesh['geometry']['attributes'][string];

const readable = (attribute: Attribute | undefined) =>
  attribute !== undefined && isReadable(attribute) ? attribute : undefined;

/** @param mesh - mesh whose triangles are weighted by area in the world @returns null without readable area */
export function surfaceTable(mesh: Mesh): SurfaceTable | null {
  const { geometry } = mesh;
  const { position: positions } = geometry.attributes;
  if (positions === undefined) return null;
  if (!hasReadableVertices(geometry)) {
    console.warn(
      `Farol: no particles begin on ${mesh.type} "${mesh.name || mesh.uuid}", since its arrays were freed after upload; keep them.`,
    );
    return null;
  }
  const normals = readable(geometry.attributes.normal);
  const { index } = geometry;
  const triangles = Math.floor((index ?? positions).count / 3);
  const data = new Float32Array(triangles * TEXELS_PER_TRIANGLE * 4);
  const areas = new Float64Array(triangles);
  const scale = new Matrix4().copy(mesh.matrixWorld).setPosition(0, 0, 0);
  for (let t = 0; t < triangles; t++) {
    const at = t * TEXELS_PER_TRIANGLE * 4;
    for (let c = 0; c < 3; c++) {
      const vertex = index === null ? t * 3 + c : index.getX(t * 3 + c);
      corners[c].fromBufferAttribute(positions, vertex).toArray(data, at + 4 * c);
      placed[c].copy(corners[c]).applyMatrix4(scale);
      if (normals !== undefined) normal.fromBufferAttribute(normals, vertex).toArray(data, at + 12 + 4 * c);
    }
    edge.subVectors(placed[1], placed[0]);
    areas[t] = edge.cross(normal.subVectors(placed[2], placed[0])).length() / 2;
    if (!(areas[t] < Infinity)) areas[t] = 0;
    if (normals !== undefined) continue;
    edge.subVectors(corners[1], corners[0]).cross(normal.subVectors(corners[2], corners[0]));
    for (let c = 0; c < 3; c++) edge.toArray(data, at + 12 + 4 * c);
  }
  if (!areas.some((area) => area > 0)) return null;
  const { share, alias } = aliasTable(areas);
  for (let t = 0; t < triangles; t++) {
    data[t * TEXELS_PER_TRIANGLE * 4 + 3] = share[t];
    data[t * TEXELS_PER_TRIANGLE * 4 + 7] = alias[t];
  }
  return { data, triangles };
}
