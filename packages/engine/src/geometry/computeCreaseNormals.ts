import { BufferAttribute, BufferGeometry, type InterleavedBufferAttribute } from 'three';
import { Slices } from '../base/Slices';
import { inSteps, runInSlices, runSteps, type Steps } from '../base/steps';
import { type Places, weldPositions } from './weldPositions';

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/**
 * Greatest number of corners at one position that are compared with each other. At positions with more (with one far
 * outlier, all other points of a scan count as one position) each corner gets its face's normal.
 */
const MOST_COMPARED = 1024;

/** Vertex index of each triangle corner; corner c belongs to triangle ⌊c / 3⌋. */
function* cornersOf({ index, attributes }: BufferGeometry): Steps<Uint32Array> {
  const count = index ? index.count : attributes.position.count;
  const corners = new Uint32Array(count - (count % 3));
  yield* inSteps(corners.length, (from, to) => {
    for (let i = from; i < to; i++) corners[i] = index ? index.getX(i) : i;
  });
  return corners;
}

interface Faces {
  /** Unit normals of the triangles, 0 for one without area. */
  readonly normals: Float64Array;
  /** Angle of each triangle corner (radians). */
  readonly angles: Float64Array;
}

function* facesOf(position: Attribute, corners: Uint32Array): Steps<Faces> {
  const normals = new Float64Array(corners.length);
  const angles = new Float64Array(corners.length);
  const p = [0, 1, 2].map(() => new Float64Array(3));
  const edge = [0, 1, 2].map(() => new Float64Array(3));
  yield* inSteps(corners.length / 3, (from, to) => {
    for (let face = from * 3; face < to * 3; face += 3) {
      for (let k = 0; k < 3; k++) {
        p[k][0] = position.getX(corners[face + k]);
        p[k][1] = position.getY(corners[face + k]);
        p[k][2] = position.getZ(corners[face + k]);
      }
      for (let k = 0; k < 3; k++) {
        const [start, end] = [p[k], p[(k + 1) % 3]];
        const length = Math.hypot(end[0] - start[0], end[1] - start[1], end[2] - start[2]);
        for (let axis = 0; axis < 3; axis++) edge[k][axis] = length > 0 ? (end[axis] - start[axis]) / length : 0;
      }
      const [a, b] = edge;
      const x = a[1] * b[2] - a[2] * b[1];
      const y = a[2] * b[0] - a[0] * b[2];
      const z = a[0] * b[1] - a[1] * b[0];
      const sine = Math.hypot(x, y, z);
      if (!(sine > 1e-12)) continue;
      normals[face] = x / sine;
      normals[face + 1] = y / sine;
      normals[face + 2] = z / sine;
      for (let k = 0; k < 3; k++) {
        const [out, back] = [edge[k], edge[(k + 2) % 3]];
        const cosine = -(out[0] * back[0] + out[1] * back[1] + out[2] * back[2]);
        angles[face + k] = Math.acos(Math.min(1, Math.max(-1, cosine)));
      }
    }
  });
  return { normals, angles };
}

/** Corners by position: those at position p are `list[start[p]] … list[start[p + 1] - 1]`. */
function* cornersByPlace(
  { places, count }: Places,
  corners: Uint32Array,
): Steps<{ start: Uint32Array; list: Uint32Array }> {
  const start = new Uint32Array(count + 1);
  yield* inSteps(corners.length, (from, to) => {
    for (let corner = from; corner < to; corner++) start[places[corners[corner]] + 1]++;
  });
  for (let i = 0; i < count; i++) start[i + 1] += start[i];
  const next = start.slice();
  const list = new Uint32Array(corners.length);
  yield* inSteps(corners.length, (from, to) => {
    for (let corner = from; corner < to; corner++) list[next[places[corners[corner]]]++] = corner;
  });
  return { start, list };
}

/** Normal of each corner: mean of its position's face normals within the crease angle, weighted by angle. */
function* cornerNormals(
  position: Attribute,
  corners: Uint32Array,
  welded: Places,
  creaseAngle: number,
): Steps<Float32Array> {
  const { normals, angles } = yield* facesOf(position, corners);
  const { places } = welded;
  const { start, list } = yield* cornersByPlace(welded, corners);
  const leastCosine = Math.cos(Math.min(creaseAngle, Math.PI)) - 1e-9;
  const result = new Float32Array(corners.length * 3);
  yield* inSteps(corners.length, (from, to) => {
    for (let corner = from; corner < to; corner++) {
      const own = corner - (corner % 3);
      const place = places[corners[corner]];
      const flat = normals[own] === 0 && normals[own + 1] === 0 && normals[own + 2] === 0;
      let [x, y, z] = [0, 0, 0];
      const end = start[place + 1] - start[place] > MOST_COMPARED ? 0 : start[place + 1];
      for (let i = start[place]; i < end; i++) {
        const face = list[i] - (list[i] % 3);
        const cosine =
          normals[own] * normals[face] + normals[own + 1] * normals[face + 1] + normals[own + 2] * normals[face + 2];
        if (!flat && cosine < leastCosine) continue;
        const weight = angles[list[i]];
        x += normals[face] * weight;
        y += normals[face + 1] * weight;
        z += normals[face + 2] * weight;
      }
      const length = Math.hypot(x, y, z);
      if (length > 1e-9) result.set([x / length, y / length, z / length], corner * 3);
      else if (flat) result.set([0, 1, 0], corner * 3);
      else result.set([normals[own], normals[own + 1], normals[own + 2]], corner * 3);
    }
  });
  return result;
}

/** Merges corners with equal position, normal and attributes into the vertices of the result. */
function* joinCorners(
  geometry: BufferGeometry,
  corners: Uint32Array,
  { places, count }: Places,
  normals: Float32Array,
): Steps<{ index: Uint32Array; kept: readonly number[] }> {
  const others = Object.entries(geometry.attributes).filter(([name]) => name !== 'normal' && name !== 'position');
  const sameAttributes = (a: number, b: number): boolean => {
    if (a === b) return true;
    return others.every(([, attribute]) => {
      for (let k = 0; k < attribute.itemSize; k++) {
        if (attribute.getComponent(a, k) !== attribute.getComponent(b, k)) return false;
      }
      return true;
    });
  };
  const first = new Int32Array(count).fill(-1);
  const sizes = new Uint32Array(count);
  const next: number[] = [];
  const kept: number[] = [];
  const index = new Uint32Array(corners.length);
  yield* inSteps(corners.length, (from, to) => {
    for (let corner = from; corner < to; corner++) {
      const place = places[corners[corner]];
      let vertex = sizes[place] < MOST_COMPARED ? first[place] : -1;
      while (vertex >= 0) {
        const [a, b] = [corner * 3, kept[vertex] * 3];
        const gap =
          Math.abs(normals[a] - normals[b]) +
          Math.abs(normals[a + 1] - normals[b + 1]) +
          Math.abs(normals[a + 2] - normals[b + 2]);
        if (gap < 1e-4 && sameAttributes(corners[corner], corners[kept[vertex]])) break;
        vertex = next[vertex];
      }
      if (vertex < 0) {
        vertex = kept.push(corner) - 1;
        next.push(first[place]);
        first[place] = vertex;
        sizes[place]++;
      }
      index[corner] = vertex;
    }
  });
  return { index, kept };
}

function* creaseNormals(geometry: BufferGeometry, creaseAngle: number): Steps<BufferGeometry> {
  const position = geometry.getAttribute('position') as Attribute | undefined;
  if (!position) throw new Error('The geometry has no position attribute: normals need one.');
  const corners = yield* cornersOf(geometry);
  const welded = yield* weldPositions(position);
  const normals = yield* cornerNormals(position, corners, welded, creaseAngle);
  const { index, kept } = yield* joinCorners(geometry, corners, welded, normals);
  const result = new BufferGeometry();
  result.name = geometry.name;
  for (const [name, source] of Object.entries(geometry.attributes)) {
    if (name === 'normal') continue;
    const { itemSize } = source;
    const target = new BufferAttribute(new Float32Array(kept.length * itemSize), itemSize);
    yield* inSteps(kept.length, (from, to) => {
      for (let vertex = from; vertex < to; vertex++) {
        const corner = corners[kept[vertex]];
        for (let k = 0; k < itemSize; k++) target.setComponent(vertex, k, source.getComponent(corner, k));
      }
    });
    result.setAttribute(name, target);
  }
  const normal = new BufferAttribute(new Float32Array(kept.length * 3), 3);
  yield* inSteps(kept.length, (from, to) => {
    for (let vertex = from; vertex < to; vertex++) {
      const at = kept[vertex] * 3;
      normal.setXYZ(vertex, normals[at], normals[at + 1], normals[at + 2]);
    }
  });
  result.setAttribute('normal', normal);
  result.setIndex(new BufferAttribute(index, 1));
  for (const group of geometry.groups) result.addGroup(group.start, group.count, group.materialIndex);
  result.computeBoundingSphere();
  return result;
}

/**
 * A copy of a triangle geometry with normals: smooth at edges of up to `creaseAngle`, creased at sharper ones. Corners
 * are welded by position, so texture seams stay invisible; faces are weighted by corner angle (Thürmer and Wüthrich
 * 1998), so the triangulation stays invisible too; more than 1,024 corners at one position keep their faces' normals.
 * Other attributes and groups are kept; morph targets are not.
 * @param geometry - indexed or not, with a `position` attribute; not changed
 * @param creaseAngle - radians, 0 (flat) to π (all smooth); π / 6 when absent
 */
export const computeCreaseNormals = (geometry: BufferGeometry, creaseAngle = Math.PI / 6): BufferGeometry =>
  runSteps(creaseNormals(geometry, creaseAngle));

/**
 * As `computeCreaseNormals`, computed in slices of 20 ms, so that the page stays responsive.
 * @param signal - cancels the work
 * @throws the signal's abort reason (as a rejection)
 */
export const computeCreaseNormalsInSlices = (
  geometry: BufferGeometry,
  creaseAngle: number,
  signal?: AbortSignal,
): Promise<BufferGeometry> => runInSlices(creaseNormals(geometry, creaseAngle), new Slices(signal));
