import type { SurfaceToUnwrap, UnwrappedMesh } from '../unwrap/UnwrapRequest';

/** Cosine between normals above which an edge is smooth: light is equal on both sides. */
const SMOOTH = 0.95;
/** Positions nearer than this share of the surface's extent are equal. */
const NEAR = 1e-5;

/**
 * Finds the smooth edges along which charts cut a surface: two triangles share such an edge in space but not in the
 * lightmap. Hard edges are ignored, since light may differ there.
 *
 * @returns vertices of the unwrapped mesh, four per seam: both ends on one side, and both ends on the other
 */
export function findSeams(
  { positions, normals }: SurfaceToUnwrap,
  { uv1, index, sourceVertex }: Pick<UnwrappedMesh, 'uv1' | 'index' | 'sourceVertex'>,
): Uint32Array {
  const place = placesOf(positions);
  const places = positions.length / 3;
  const faces = normals ? null : faceNormals(positions, index, sourceVertex);
  /** By an edge's two positions: first corner found there, and its vertices at the lower and the higher position. */
  const known = new Map<number, readonly [number, number, number]>();
  const seams: number[] = [];
  const isSame = (a: number, b: number): boolean =>
    a === b || (Math.abs(uv1[2 * a] - uv1[2 * b]) < 1e-6 && Math.abs(uv1[2 * a + 1] - uv1[2 * b + 1]) < 1e-6);
  const dot = (a: Float32Array, i: number, k: number): number =>
    a[3 * i] * a[3 * k] + a[3 * i + 1] * a[3 * k + 1] + a[3 * i + 2] * a[3 * k + 2];
  for (let corner = 0; corner < index.length; corner++) {
    const from = index[corner];
    const to = index[corner % 3 === 2 ? corner - 2 : corner + 1];
    const [a, b] = [place[sourceVertex[from]], place[sourceVertex[to]]];
    if (a === b) continue;
    const [low, high] = a < b ? [from, to] : [to, from];
    const key = Math.min(a, b) * places + Math.max(a, b);
    const other = known.get(key);
    if (!other) {
      known.set(key, [corner, low, high]);
      continue;
    }
    const [otherCorner, otherLow, otherHigh] = other;
    if (isSame(low, otherLow) && isSame(high, otherHigh)) continue;
    const isSmooth = normals
      ? dot(normals, sourceVertex[low], sourceVertex[otherLow]) > SMOOTH &&
        dot(normals, sourceVertex[high], sourceVertex[otherHigh]) > SMOOTH
      : dot(faces!, Math.floor(corner / 3), Math.floor(otherCorner / 3)) > SMOOTH;
    if (isSmooth) seams.push(low, high, otherLow, otherHigh);
  }
  return Uint32Array.from(seams);
}

/** Index of each vertex's position, equal for vertices at one position. */
function placesOf(positions: Float32Array): Uint32Array {
  let [least, most] = [Infinity, -Infinity];
  for (const value of positions) {
    least = Math.min(least, value);
    most = Math.max(most, value);
  }
  const step = Math.max(most - least, 1e-12) * NEAR;
  const known = new Map<string, number>();
  return Uint32Array.from({ length: positions.length / 3 }, (_, i) => {
    const key = [0, 1, 2].map((k) => Math.round(positions[3 * i + k] / step)).join();
    const found = known.get(key);
    if (found === undefined) known.set(key, known.size);
    return found ?? known.size - 1;
  });
}

function faceNormals(positions: Float32Array, index: Uint32Array, sourceVertex: Uint32Array): Float32Array {
  const normals = new Float32Array(index.length);
  for (let i = 0; i < index.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * sourceVertex[index[i + k]]);
    const [ux, uy, uz] = [0, 1, 2].map((k) => positions[b + k] - positions[a + k]);
    const [vx, vy, vz] = [0, 1, 2].map((k) => positions[c + k] - positions[a + k]);
    const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const length = Math.hypot(...normal) || 1;
    normals.set(
      normal.map((each) => each / length),
      i,
    );
  }
  return normals;
}
