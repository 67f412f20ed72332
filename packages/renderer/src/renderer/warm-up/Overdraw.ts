import {
  BackSide,
  type BufferGeometry,
  type Camera,
  DoubleSide,
  type InstancedMesh,
  Matrix3,
  Matrix4,
  type Object3D,
} from 'three';
import type { RenderItem } from '../../frame/RenderItem';
import type { OpaqueItems } from '../../frame/RenderQueue';
import type { DirectDraw } from '../../three/directDraw';
import { isBeside, isFar, MaterialOrder, MOST_MATERIALS } from './MaterialOrder';
import { geometryPoints, POINT, POINTS, surfacePoints } from './surfacePoints';

/** Maximum number of cells along a side of the picture, and smallest mean number of parts in a cell. */
const MOST_CELLS = 8;
const POINTS_A_CELL = 16;
/** Number of frames from one estimate to the next, and of the frames just before it over which items' points are computed. */
const INTERVAL = 64;
const AHEAD = 8;
/** Number of opaque items beyond which nothing is estimated, since the CPU then takes longer than the GPU. */
const MOST_ITEMS = 1000;
/** Maximum number of points of all items together: each item has fewer where there are many items. */
const MOST_POINTS = 6144;
/** Capacity of the arrays below, which describe parts. */
const MOST_PARTS = MOST_POINTS + MOST_ITEMS;
/** Number of runs (successive items of one material and render order) beyond which materials are drawn in three's order. */
const MOST_RUNS = MOST_MATERIALS;
/** Number of shaded pixels (0.5 ns each) that an order of materials must save: sorting takes the CPU a few microseconds. */
const LEAST_SAVED = 10_000;
/** Clip-space w below which a point counts as behind the camera. */
const BEHIND = 1e-3;

/** Parts of a frame that an estimate reads. */
export interface EstimatedFrame {
  readonly camera: Camera;
  /** Size of the picture (pixels). */
  readonly width: number;
  readonly height: number;
  readonly queue: OpaqueItems;
}

const toView = new Matrix4();
const normals = new Matrix3();
/** Parts of the picture, one around each point: depth (m), position from left and bottom (0 to 1), run, share of the picture. */
const depths = new Float64Array(MOST_PARTS);
const columns = new Float64Array(MOST_PARTS);
const rows = new Float64Array(MOST_PARTS);
const runOf = new Uint8Array(MOST_PARTS);
const areas = new Float64Array(MOST_PARTS);
/** Sort key of each part: depth and index in one number. */
const keys = new Float64Array(MOST_PARTS);
/** First item of each run, in the order in which they are drawn; empty between estimates. */
const runs: RenderItem[] = [];
/** Place of each run in the order of draws: a run is drawn after those of lower places. */
const places = new Float64Array(MOST_RUNS);
/** Number of items of each run. */
const lengths = new Uint16Array(MOST_RUNS);
/** Index of each run's material, in the order of ids. */
const materialOf = new Uint8Array(MOST_RUNS);
/** Area of a material (cells) that another one hides, at index material × MOST_RUNS + other. */
const wastes = new Float64Array(MOST_RUNS * MOST_RUNS);
/** Share of each cell that the nearer parts of each run cover, 0 to 1. */
const front = new Float64Array(MOST_CELLS * MOST_CELLS * MOST_RUNS);
/** Area of a run that another run hides (cells), at index other run × MOST_RUNS + run. */
const hides = new Float64Array(MOST_RUNS * MOST_RUNS);

/**
 * Estimate of how often the opaque items of a scene shade a pixel that a later one hides, and of the order of materials
 * that avoids most of it, from points on the items' surfaces in cells of the picture. Computed again every 64 frames.
 */
export class Overdraw {
  /** Mean number of shadings of a pixel beyond the first; the mean of the last estimate and the value before. */
  layers = 0;
  /** Number of triangles of the items that a depth pre-pass would draw. */
  triangles = 0;
  /** Order of materials, for `RenderQueue.order`; null where it saves too little. */
  order: MaterialOrder | null = null;
  private readonly found: MaterialOrder;
  private frames = 0;
  private parts = 0;
  private cells = 1;

  /** @param draw - draws items in the order found by LessDepth, where they need it */
  constructor(draw: DirectDraw) {
    this.found = new MaterialOrder(draw);
  }

  /** Counts a drawn frame, and makes an estimate in every 64th. */
  follow({ camera, width, height, queue }: EstimatedFrame): void {
    const { opaque } = queue;
    const frame = this.frames++ % INTERVAL;
    if (frame < AHEAD && opaque.length <= MOST_ITEMS)
      for (let i = frame; i < opaque.length; i += AHEAD) geometryPoints(opaque[i]);
    if (frame !== AHEAD) return;
    let saved = 0;
    let layers = 0;
    if (opaque.length <= MOST_ITEMS) {
      const hasFewRuns = this.place(opaque, camera, 0);
      if (!hasFewRuns) this.place(opaque, camera, Math.ceil(opaque.length / MOST_RUNS));
      layers = this.compare();
      if (hasFewRuns && runs.length > 0 && isBeside(opaque[0], opaque[opaque.length - 1]))
        saved = this.findOrder(queue);
    }
    this.order = saved * width * height < LEAST_SAVED ? null : this.found;
    this.layers = this.frames < INTERVAL ? layers : (this.layers + layers) / 2;
    runs.length = 0;
  }

  /**
   * Finds the parts of the picture that items cover.
   * @param size - number of items of a run, whatever their material; 0: as many as share material and render order
   * @returns false for too many runs
   */
  private place(items: readonly RenderItem[], camera: Camera, size: number): boolean {
    // an estimate that a host's getter ended by throwing may have left items here
    runs.length = this.parts = this.triangles = 0;
    const step = Math.ceil((items.length * POINTS) / MOST_POINTS);
    let last: RenderItem | null = null;
    for (let i = 0; i < items.length; i++) {
      const item = items[i];
      if (item.route !== 'split') continue;
      this.triangles += trianglesOf(item);
      const isAlike = last?.material === item.material && isBeside(last, item) && last.z <= item.z;
      if (last === null || (size > 0 ? i % size === 0 : !isAlike)) {
        if (runs.length === MOST_RUNS) return false;
        places[runs.length] = (this.order?.rankOf(item) ?? 0) * MOST_RUNS + runs.length;
        lengths[runs.length] = 0;
        runs.push(item);
      }
      lengths[runs.length - 1]++;
      last = item;
      this.placeItem(item, camera, step);
    }
    return true;
  }

  private placeItem(item: RenderItem, camera: Camera, step: number): void {
    const { side } = item.material;
    const m = toView.multiplyMatrices(camera.matrixWorldInverse, item.object.matrixWorld).elements;
    const n = normals.getNormalMatrix(toView).elements;
    const p = camera.projectionMatrix.elements;
    const scale = Math.abs(toView.determinant() * p[0] * p[5]) * 0.25 * step;
    const points = surfacePoints(item);
    for (let i = 0; i < points.length; i += POINT * step) {
      const x = m[0] * points[i] + m[4] * points[i + 1] + m[8] * points[i + 2] + m[12];
      const y = m[1] * points[i] + m[5] * points[i + 1] + m[9] * points[i + 2] + m[13];
      const z = m[2] * points[i] + m[6] * points[i + 1] + m[10] * points[i + 2] + m[14];
      const w = p[3] * x + p[7] * y + p[11] * z + p[15];
      if (w < BEHIND) continue;
      const [a, b, c] = [points[i + 3], points[i + 4], points[i + 5]];
      const nz = n[2] * a + n[5] * b + n[8] * c;
      // above 0 where the surface faces the camera, or the plane of an orthographic one
      const facing =
        p[11] === 0 ? nz : -((n[0] * a + n[3] * b + n[6] * c) * x + (n[1] * a + n[4] * b + n[7] * c) * y + nz * z);
      const area = ((side === DoubleSide ? Math.abs(facing) : side === BackSide ? -facing : facing) * scale) / w ** 3;
      if (area > 0) this.add((p[0] * x + p[8] * z + p[12]) / w, (p[5] * y + p[9] * z + p[13]) / w, -z, area);
    }
  }

  /** Adds a part around a point in normalised device coordinates. @param area - share of the picture */
  private add(x: number, y: number, depth: number, area: number): void {
    if (!(Math.abs(x) < 1 && Math.abs(y) < 1)) return;
    const part = this.parts++;
    depths[part] = depth;
    columns[part] = (x + 1) / 2;
    rows[part] = (y + 1) / 2;
    runOf[part] = runs.length - 1;
    areas[part] = area;
  }

  /** Visits the parts from near to far, and sets `hides`. @returns share of the picture that is drawn and hidden later */
  private compare(): number {
    const { parts } = this;
    for (let i = 0; i < parts; i++) keys[i] = Math.round(Math.min(depths[i], 1e6) * 1024) * MOST_PARTS + i;
    keys.subarray(0, parts).sort();
    const side = Math.max(1, Math.min(MOST_CELLS, Math.floor(Math.sqrt(parts / POINTS_A_CELL))));
    this.cells = side * side;
    front.fill(0);
    hides.fill(0);
    let wasted = 0;
    for (let i = 0; i < parts; i++) {
      const part = keys[i] % MOST_PARTS;
      const own = runOf[part];
      const share = areas[part] * side * side;
      const cell = (Math.floor(rows[part] * side) * side + Math.floor(columns[part] * side)) * MOST_RUNS;
      let later = 0;
      for (let run = 0; run < runs.length; run++) {
        hides[run * MOST_RUNS + own] += share * front[cell + run];
        if (places[run] > places[own]) later += front[cell + run];
      }
      wasted += share * Math.min(1, later);
      front[cell + own] = Math.min(1, front[cell + own] + share);
    }
    return wasted / (side * side);
  }

  /** Finds the order of the runs' materials. @returns mean number of shadings of a pixel that it saves against three's order */
  private findOrder(queue: OpaqueItems): number {
    const ids: number[] = [];
    wastes.fill(0);
    for (let run = 0; run < runs.length; run++) {
      const { id } = runs[run].material;
      if (id < ids[ids.length - 1]) return 0; // the host has an order of its own
      if (ids[ids.length - 1] !== id) ids.push(id);
      materialOf[run] = ids.length - 1;
      const row = materialOf[run] * MOST_RUNS;
      // a part is hidden by its own item in the estimate alone
      wastes[row + materialOf[run]] += hides[run * MOST_RUNS + run] * (1 - 1 / lengths[run]);
      for (let other = 0; other < run; other++) {
        wastes[row + materialOf[other]] += hides[other * MOST_RUNS + run];
        wastes[materialOf[other] * MOST_RUNS + materialOf[run]] += hides[run * MOST_RUNS + other];
      }
    }
    for (const item of queue.opaque) {
      const material = ids.indexOf(item.material.id);
      // must not be drawn by LessDepth
      if (material >= 0 && isFar(queue, item)) wastes[material * (MOST_RUNS + 1)] = Infinity;
    }
    return this.found.find(ids, wastes) / this.cells;
  }
}

function trianglesOf({ object, geometry, group }: RenderItem): number {
  const { index, attributes, drawRange }: BufferGeometry = geometry;
  const all = Math.min(index?.count ?? attributes.position?.count ?? 0, drawRange.count);
  const { isInstancedMesh, count } = object as Object3D as InstancedMesh;
  return ((group === null ? all : Math.min(all, group.count)) / 3) * (isInstancedMesh ? count : 1);
}
