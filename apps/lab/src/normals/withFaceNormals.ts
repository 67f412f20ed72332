import { BufferAttribute, type BufferGeometry } from 'three';

/** Distance below which two vertices have one place (m): files round positions. */
const WELD = 1e-5;

/**
 * Copies a geometry with normals computed as engines of 2015 did: at each place the mean of the triangles that meet there,
 * weighted by area, whatever the angle between them.
 *
 * @param geometry - indexed triangles with positions; left as it is
 */
export function withFaceNormals(geometry: BufferGeometry): BufferGeometry {
  const { position } = geometry.attributes;
  const places = placesOf(geometry);
  const sums = new Float64Array((Math.max(-1, ...places) + 1) * 3);
  forEachTriangle(geometry, (corners, normal) => {
    for (const corner of corners) for (let k = 0; k < 3; k++) sums[places[corner] * 3 + k] += normal[k];
  });
  const normals = new Float32Array(position.count * 3);
  for (let i = 0; i < position.count; i++) {
    const sum = sums.subarray(places[i] * 3, places[i] * 3 + 3);
    const length = Math.hypot(...sum) || 1;
    for (let k = 0; k < 3; k++) normals[i * 3 + k] = sum[k] / length;
  }
  const copy = geometry.clone();
  copy.setAttribute('normal', new BufferAttribute(normals, 3));
  return copy;
}

/** Counts the corners of all triangles, and those whose normal deviates from the triangle's by more than an angle (radians). */
export function countLeaning(geometry: BufferGeometry, angle: number): { corners: number; leaning: number } {
  const { normal: normals } = geometry.attributes;
  const limit = Math.cos(angle);
  let corners = 0;
  let leaning = 0;
  forEachTriangle(geometry, (vertices, face) => {
    const area = Math.hypot(...face);
    if (area === 0) return;
    for (const vertex of vertices) {
      const [x, y, z] = [normals.getX(vertex), normals.getY(vertex), normals.getZ(vertex)];
      corners++;
      // tolerance for normals rounded to 32 bits
      if ((x * face[0] + y * face[1] + z * face[2]) / area < limit - 1e-6) leaning++;
    }
  });
  return { corners, leaning };
}

type Triple = [number, number, number];

/** Calls `use` for each triangle with its vertices and its normal times twice its area; both arrays are reused. */
function forEachTriangle(geometry: BufferGeometry, use: (corners: Triple, normal: Triple) => void): void {
  const { index, attributes } = geometry;
  const { position } = attributes;
  const count = index ? index.count : position.count;
  const corners: Triple = [0, 0, 0];
  const normal: Triple = [0, 0, 0];
  for (let i = 0; i + 2 < count; i += 3) {
    for (let k = 0; k < 3; k++) corners[k] = index ? index.getX(i + k) : i + k;
    const [a, b, c] = corners;
    const [ux, uy, uz] = [0, 1, 2].map((k) => position.getComponent(b, k) - position.getComponent(a, k));
    const [vx, vy, vz] = [0, 1, 2].map((k) => position.getComponent(c, k) - position.getComponent(a, k));
    normal[0] = uy * vz - uz * vy;
    normal[1] = uz * vx - ux * vz;
    normal[2] = ux * vy - uy * vx;
    use(corners, normal);
  }
}

/** Index of the place of each vertex; vertices at one place share it. */
function placesOf({ attributes: { position } }: BufferGeometry): Uint32Array {
  const numbers = new Map<string, number>();
  const places = new Uint32Array(position.count);
  for (let i = 0; i < position.count; i++) {
    const key = [0, 1, 2].map((k) => Math.round(position.getComponent(i, k) / WELD)).join();
    const number = numbers.get(key) ?? numbers.size;
    numbers.set(key, number);
    places[i] = number;
  }
  return places;
}
