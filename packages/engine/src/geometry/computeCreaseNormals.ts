import { BufferAttribute, BufferGeometry, type InterleavedBufferAttribute } from 'three';
import { weldPositions } from './weldPositions';

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/** Corner c of triangle c / 3 takes vertex `corners[c]`. */
function cornersOf(geometry: BufferGeometry): Uint32Array {
  const { index } = geometry;
  const count = index ? index.count : geometry.getAttribute('position').count;
  return Uint32Array.from({ length: count - (count % 3) }, (_, i) => (index ? index.getX(i) : i));
}

/** Unit normals of the triangles (0 for one without area) and the angle of each corner, in radians. */
function faceNormals(position: Attribute, corners: Uint32Array): { normals: Float64Array; angles: Float64Array } {
  const normals = new Float64Array(corners.length);
  const angles = new Float64Array(corners.length);
  const p = [0, 1, 2].map(() => new Float64Array(3));
  const edge = [0, 1, 2].map(() => new Float64Array(3));
  for (let face = 0; face < corners.length; face += 3) {
    for (let k = 0; k < 3; k++) {
      p[k][0] = position.getX(corners[face + k]);
      p[k][1] = position.getY(corners[face + k]);
      p[k][2] = position.getZ(corners[face + k]);
    }
    for (let k = 0; k < 3; k++) {
      const [from, to] = [p[k], p[(k + 1) % 3]];
      const length = Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
      for (let axis = 0; axis < 3; axis++) edge[k][axis] = length > 0 ? (to[axis] - from[axis]) / length : 0;
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
  return { normals, angles };
}

/** Corners that share a place: those of place p are `list[start[p]] … list[start[p + 1] - 1]`. */
function cornersByPlace(
  places: Uint32Array,
  corners: Uint32Array,
  count: number,
): { start: Uint32Array; list: Uint32Array } {
  const start = new Uint32Array(count + 1);
  for (const vertex of corners) start[places[vertex] + 1]++;
  for (let i = 0; i < count; i++) start[i + 1] += start[i];
  const next = start.slice();
  const list = new Uint32Array(corners.length);
  for (let corner = 0; corner < corners.length; corner++) list[next[places[corners[corner]]]++] = corner;
  return { start, list };
}

/** A normal for each corner: the mean of the faces round its place within the crease angle, weighted by their angle. */
function cornerNormals(geometry: BufferGeometry, corners: Uint32Array, creaseAngle: number): Float32Array {
  const position = geometry.getAttribute('position');
  const { normals, angles } = faceNormals(position, corners);
  const { places, count } = weldPositions(position);
  const { start, list } = cornersByPlace(places, corners, count);
  const leastCosine = Math.cos(Math.min(creaseAngle, Math.PI)) - 1e-9;
  const result = new Float32Array(corners.length * 3);
  for (let corner = 0; corner < corners.length; corner++) {
    const own = corner - (corner % 3);
    const place = places[corners[corner]];
    const flat = normals[own] === 0 && normals[own + 1] === 0 && normals[own + 2] === 0;
    let [x, y, z] = [0, 0, 0];
    for (let i = start[place]; i < start[place + 1]; i++) {
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
  return result;
}

/** Joins corners that agree in place, normal and every attribute: the vertices of the result. */
function joinCorners(
  geometry: BufferGeometry,
  corners: Uint32Array,
  normals: Float32Array,
): { index: Uint32Array; kept: number[] } {
  const { places, count } = weldPositions(geometry.getAttribute('position'));
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
  const next: number[] = [];
  const kept: number[] = [];
  const index = new Uint32Array(corners.length);
  for (let corner = 0; corner < corners.length; corner++) {
    const place = places[corners[corner]];
    let vertex = first[place];
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
    }
    index[corner] = vertex;
  }
  return { index, kept };
}

/**
 * A copy of a triangle geometry with normals: smooth where faces meet at an angle up to `creaseAngle`, creased where
 * they meet at more. Corners are welded by place, so seams of the texture coordinates do not show; faces count by the
 * angle that they have at the corner (Thürmer and Wüthrich 1998), so that the cut of a face into triangles does not
 * show either. Other attributes and groups are kept; morph targets are not.
 * @param geometry - indexed or not, with a `position` attribute; left as it is
 * @param creaseAngle - radians, 0 (flat) to π (all smooth); π / 6 when absent
 */
export function computeCreaseNormals(geometry: BufferGeometry, creaseAngle = Math.PI / 6): BufferGeometry {
  if (!geometry.getAttribute('position')) throw new Error('Normals need a geometry with a position attribute.');
  const corners = cornersOf(geometry);
  const normals = cornerNormals(geometry, corners, creaseAngle);
  const { index, kept } = joinCorners(geometry, corners, normals);
  const result = new BufferGeometry();
  result.name = geometry.name;
  for (const [name, source] of Object.entries(geometry.attributes)) {
    if (name === 'normal') continue;
    const { itemSize } = source;
    const target = new BufferAttribute(new Float32Array(kept.length * itemSize), itemSize);
    kept.forEach((corner, vertex) => {
      for (let k = 0; k < itemSize; k++) target.setComponent(vertex, k, source.getComponent(corners[corner], k));
    });
    result.setAttribute(name, target);
  }
  const normal = new BufferAttribute(new Float32Array(kept.length * 3), 3);
  kept.forEach((corner, vertex) => {
    normal.setXYZ(vertex, normals[corner * 3], normals[corner * 3 + 1], normals[corner * 3 + 2]);
  });
  result.setAttribute('normal', normal);
  result.setIndex(new BufferAttribute(index, 1));
  for (const group of geometry.groups) result.addGroup(group.start, group.count, group.materialIndex);
  result.computeBoundingSphere();
  return result;
}
