import type { BufferAttribute, BufferGeometry } from 'three';

/** Triangles of a cluster. */
const CLUSTER_TRIANGLES = 128;
/** Vertices, or indices, of a cluster. */
export const CLUSTER_VERTICES = 3 * CLUSTER_TRIANGLES;
/** Triangles below which a mesh is not taken apart. */
const FEWEST = 4 * CLUSTER_TRIANGLES;

interface Clusters {
  readonly position: BufferAttribute;
  readonly positions: number;
  readonly index: BufferAttribute | null;
  readonly indices: number;
  readonly boxes: Float32Array | null;
}

const known = new WeakMap<BufferGeometry, Clusters>();

/**
 * Boxes of each 128 triangles of a geometry that follow one another in its index (or its vertices), in its own space: centre
 * and half sizes (m), 6 numbers each. What is far from a light can be left out of its map by them.
 * @returns null for few triangles, and where positions or index were changed since they were first seen: that may go on
 */
export function triangleClusters(geometry: BufferGeometry): Float32Array | null {
  const position = geometry.attributes.position as BufferAttribute | undefined;
  if (position === undefined) return null;
  const { index } = geometry;
  const { version: positions = 0 } = position;
  const indices = index?.version ?? 0;
  let clusters = known.get(geometry);
  const same = clusters !== undefined && clusters.position === position && clusters.index === index;
  if (!same || clusters!.positions !== positions || clusters!.indices !== indices) {
    const boxes = clusters === undefined ? boxesOf(position, index) : null;
    clusters = { position, positions, index, indices, boxes };
    known.set(geometry, clusters);
  }
  return clusters!.boxes;
}

function boxesOf(position: BufferAttribute, index: BufferAttribute | null): Float32Array | null {
  const vertices = index === null ? position.count : index.count;
  if (vertices < 3 * FEWEST) return null;
  const boxes = new Float32Array(Math.ceil(vertices / CLUSTER_VERTICES) * 6);
  const low = [0, 0, 0];
  const high = [0, 0, 0];
  for (let first = 0, at = 0; first < vertices; first += CLUSTER_VERTICES, at += 6) {
    low.fill(Infinity);
    high.fill(-Infinity);
    const end = Math.min(vertices, first + CLUSTER_VERTICES);
    for (let i = first; i < end; i++) {
      const vertex = index === null ? i : index.getX(i);
      for (let axis = 0; axis < 3; axis++) {
        const value = position.getComponent(vertex, axis);
        if (value < low[axis]) low[axis] = value;
        if (value > high[axis]) high[axis] = value;
      }
    }
    for (let axis = 0; axis < 3; axis++) {
      boxes[at + axis] = 0.5 * (low[axis] + high[axis]);
      boxes[at + 3 + axis] = 0.5 * (high[axis] - low[axis]);
    }
    // broken positions are left to the device, as they are without clusters
    if (!Number.isFinite(boxes[at] + boxes[at + 1] + boxes[at + 2] + boxes[at + 3] + boxes[at + 4] + boxes[at + 5])) {
      return null;
    }
  }
  return boxes;
}
