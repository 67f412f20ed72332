import type { BufferGeometry, Camera, InstancedMesh, Object3D, Sphere } from 'three';
import type { RenderItem } from '../../frame/RenderItem';
import { byState } from '../../frame/RenderQueue';
import type { RenderListItem } from '../../three/RenderListItem';
import { isReadable } from '../../three/vertexData';

/** Number of cells along a side of the picture. */
const SIDE = 8;
/** Number of frames from one estimate to the next. */
const INTERVAL = 32;
/** Number of opaque items beyond which nothing is estimated, since the CPU then takes longer than the GPU. */
const MOST_ITEMS = 1000;
/** Maximum number of a geometry's vertices, evenly spread, from which its box is computed. */
const SAMPLES = 64;
/** Share of a cell that an item must cover to hide what is behind it. */
const HIDES = 0.5;
/** Number of pixels that a GPU shades (0.5 ns each) while the CPU changes material (2 µs). */
const PIXELS_A_CHANGE = 4000;
/** Clip-space w below which a corner counts as behind the camera. */
const BEHIND = 1e-3;

/**
 * Order front to back by octaves of depth, which saves shading of hidden pixels; within an octave as `byState`, which saves
 * changes of material.
 */
export function byOctave(a: RenderListItem, b: RenderListItem): number {
  return a.groupOrder - b.groupOrder || a.renderOrder - b.renderOrder || octaveOf(a.z) - octaveOf(b.z) || byState(a, b);
}

/** Octave of a depth (m), from 1/1024 on; 0 for nearer depths, and behind the camera. */
const octaveOf = (z: number): number => 32 - Math.clz32(Math.max(0, z * 1024));

/** Parts of a frame that an estimate reads. */
export interface EstimatedFrame {
  readonly camera: Camera;
  /** Size of the picture (pixels). */
  readonly width: number;
  readonly height: number;
  readonly queue: { readonly opaque: readonly RenderItem[]; readonly order: unknown };
}

/** Boxes of geometries in their own space, min and max; null for one without positions. */
const boxes = new WeakMap<BufferGeometry, Float32Array | null>();
const sphereBox = new Float32Array(6);
/** Nearest depth drawn so far, and share that is drawn, of each cell. */
const depths = new Float32Array(SIDE * SIDE);
const covered = new Float32Array(SIDE * SIDE);
/** Projection × view × world. */
const m = new Float64Array(16);
/** Items of the frame sorted by the other order; empty between estimates. */
const reordered: RenderItem[] = [];
/** Rectangle of an item in cells: left, right, bottom, top; then its depth. */
const rectangle = new Float64Array(5);

/**
 * Estimate of how often the opaque items of a scene shade a pixel that a later one hides: the boxes of items, in the order in
 * which they are drawn, over 8 × 8 cells of the picture. Against counts: atrium 1.0 (1.2), temple 0.2 (0.3), a room of planes
 * 0.5 (0.1), dragons 0.4 (0.2). Computed again every 32 frames, as the mean of old and new; without allocation.
 */
export class Overdraw {
  /** Shadings beyond the first, of a pixel on average. */
  layers = 0;
  /** Number of triangles of the items that a depth pre-pass would draw. */
  triangles = 0;
  /** `RenderQueue.order`: by octaves if that saves more GPU time than its changes of material cost the CPU; else null. */
  order: typeof byOctave | null = null;
  private frames = 0;

  /** Counts a drawn frame, and estimates anew in every 32nd. */
  follow({ camera, queue: { opaque, order }, width, height }: EstimatedFrame): void {
    if (this.frames++ % INTERVAL !== 0) return;
    const isFirst = this.frames === 1;
    if (opaque.length > MOST_ITEMS) {
      this.layers /= 2;
      this.order = null;
      return;
    }
    // an estimate that a host's getter ended by throwing may have left items here
    reordered.length = opaque.length;
    for (let i = 0; i < opaque.length; i++) reordered[i] = opaque[i];
    reordered.sort(order === null ? byOctave : byState);
    const sign = order === null ? -1 : 1;
    const other = this.estimate(reordered, camera);
    const layers = this.estimate(opaque, camera);
    const changes = sign * (changesOf(opaque) - changesOf(reordered));
    const isNearFirst = sign * (other - layers) * width * height > PIXELS_A_CHANGE * changes;
    this.order = isNearFirst ? byOctave : null;
    this.layers = isFirst ? layers : (this.layers + layers) / 2;
    reordered.length = 0;
  }

  private estimate(items: readonly RenderItem[], camera: Camera): number {
    depths.fill(Infinity);
    covered.fill(0);
    this.triangles = 0;
    let drawn = 0;
    for (let i = 0; i < items.length; i++) {
      const { object, geometry, group, route } = items[i];
      if (route !== 'split') continue;
      this.triangles += trianglesOf(object, geometry, group);
      const box = boxOf(object, geometry);
      if (box === null || !project(box, object, camera)) continue;
      drawn += draw();
    }
    let first = 0;
    for (let i = 0; i < covered.length; i++) first += covered[i];
    return (drawn - first) / covered.length;
  }
}

/** Number of changes of material from one item to the next. */
function changesOf(items: readonly RenderItem[]): number {
  let changes = 0;
  for (let i = 1; i < items.length; i++) if (items[i].material !== items[i - 1].material) changes++;
  return changes;
}

/** Draws `rectangle` into the grid of depths. @returns number of cells in which it is nearest, by area */
function draw(): number {
  const [left, right, bottom, top, depth] = rectangle;
  let drawn = 0;
  for (let y = Math.floor(bottom); y < top; y++) {
    const height = Math.min(y + 1, top) - Math.max(y, bottom);
    for (let x = Math.floor(left); x < right; x++) {
      const cell = y * SIDE + x;
      if (depth >= depths[cell]) continue;
      const share = height * (Math.min(x + 1, right) - Math.max(x, left));
      drawn += share;
      covered[cell] = Math.min(1, covered[cell] + share);
      if (share > HIDES) depths[cell] = depth;
    }
  }
  return drawn;
}

/** Projects a box to `rectangle`. @returns false where the camera does not see the box */
function project(box: Float32Array, { matrixWorld }: Object3D, camera: Camera): boolean {
  multiply(camera.matrixWorldInverse.elements, matrixWorld.elements);
  const depth = (m[2] * (box[0] + box[3]) + m[6] * (box[1] + box[4]) + m[10] * (box[2] + box[5])) / 2 + m[14];
  const p = camera.projectionMatrix.elements;
  let [left, right, bottom, top] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let corner = 0; corner < 8; corner++) {
    const x = box[corner & 1 ? 3 : 0];
    const y = box[corner & 2 ? 4 : 1];
    const z = box[corner & 4 ? 5 : 2];
    const vx = m[0] * x + m[4] * y + m[8] * z + m[12];
    const vy = m[1] * x + m[5] * y + m[9] * z + m[13];
    const vz = m[2] * x + m[6] * y + m[10] * z + m[14];
    const w = p[3] * vx + p[7] * vy + p[11] * vz + p[15];
    if (w < BEHIND) {
      // a box that reaches behind the camera may be seen anywhere
      [left, right, bottom, top] = [-1, 1, -1, 1];
      break;
    }
    const sx = (p[0] * vx + p[4] * vy + p[8] * vz + p[12]) / w;
    const sy = (p[1] * vx + p[5] * vy + p[9] * vz + p[13]) / w;
    left = Math.min(left, sx);
    right = Math.max(right, sx);
    bottom = Math.min(bottom, sy);
    top = Math.max(top, sy);
  }
  rectangle[0] = cellOf(left);
  rectangle[1] = cellOf(right);
  rectangle[2] = cellOf(bottom);
  rectangle[3] = cellOf(top);
  // the view looks along -z
  rectangle[4] = -depth;
  return rectangle[0] < rectangle[1] && rectangle[2] < rectangle[3];
}

/** Cells from the left or the bottom, of a normalised device coordinate. */
const cellOf = (coordinate: number): number => Math.max(0, Math.min(SIDE, ((coordinate + 1) / 2) * SIDE));

/** Sets `m` to a × b of 4 × 4 matrices. */
function multiply(a: readonly number[], b: readonly number[]): void {
  for (let column = 0; column < 16; column += 4) {
    for (let row = 0; row < 4; row++) {
      m[column + row] =
        a[row] * b[column] + a[row + 4] * b[column + 1] + a[row + 8] * b[column + 2] + a[row + 12] * b[column + 3];
    }
  }
}

function trianglesOf(object: Object3D, { index, attributes, drawRange }: BufferGeometry, group: RenderItem['group']) {
  const all = Math.min(index?.count ?? attributes.position?.count ?? 0, drawRange.count);
  const { isInstancedMesh, count } = object as InstancedMesh;
  return ((group === null ? all : Math.min(all, group.count)) / 3) * (isInstancedMesh ? count : 1);
}

/** Box of an item in its object's space; null if unknown. */
function boxOf(object: Object3D, geometry: BufferGeometry): Float32Array | null {
  // instances, batches and skins have their own bounds, which three computes to cull them
  const { boundingSphere } = object as Object3D & { boundingSphere?: Sphere | null };
  if (boundingSphere === undefined) {
    let box = boxes.get(geometry);
    if (box === undefined) boxes.set(geometry, (box = sampledBox(geometry)));
    return box;
  }
  if (boundingSphere === null) return null;
  const { center, radius } = boundingSphere;
  for (let axis = 0; axis < 3; axis++) {
    const middle = axis === 0 ? center.x : axis === 1 ? center.y : center.z;
    sphereBox[axis] = middle - radius;
    sphereBox[axis + 3] = middle + radius;
  }
  return sphereBox;
}

function sampledBox({ attributes }: BufferGeometry): Float32Array | null {
  const { position } = attributes;
  if (position === undefined || position.count === 0 || !isReadable(position)) return null;
  const box = new Float32Array([Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity]);
  const step = Math.ceil(position.count / SAMPLES);
  for (let i = 0; i < position.count; i += step) {
    for (let axis = 0; axis < 3; axis++) {
      const value = position.getComponent(i, axis);
      box[axis] = Math.min(box[axis], value);
      box[axis + 3] = Math.max(box[axis + 3], value);
    }
  }
  return box;
}
