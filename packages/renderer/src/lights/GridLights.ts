import { coneBoundingSphere } from './spheres';
import { coneSupport } from './cones';
import type { GridFrame } from './GridFrame';
import { halfChord, projectedConeBounds, slopeBounds } from './projection';

const slopes = new Float64Array(4);
const sphere = new Float64Array(4);
const rectangle = new Float64Array(4);
/** Numbers per light in `GridLights.shapes`, and in `GridLights.tiles`. */
export const SHAPE = 10;
export const TILES = 4;
/** Margin round each light (tiles), greater than any rounding error. */
export const MARGIN = 1e-3;

/** Bounds of each light on screen; lights that touch no tile are left out. Arrays grow as needed and are reused. */
export class GridLights {
  count = 0;
  /** Nearest and farthest depth of all lights (m). */
  nearest = 0;
  farthest = 0;
  /** Index of each light in the caller's list. */
  index = new Uint32Array(0);
  /**
   * Ten numbers for each light: x, y, depth, radius of its bounding sphere (m); its rectangle: left, right (tiles), bottom, top
   * (slopes); nearest and farthest depth (m) between near and far plane.
   */
  shapes = new Float64Array(0);
  /** Tiles of each light: first column, last column, first row, last row. */
  tiles = new Uint16Array(0);

  /** Parameters as for `LightGrid.update`. */
  collect(
    count: number,
    spheres: ArrayLike<number>,
    cones: ArrayLike<number> | null,
    projection: ArrayLike<number>,
    frame: GridFrame,
  ): void {
    if (this.index.length < count) this.reserve(count);
    this.count = 0;
    this.nearest = Infinity;
    this.farthest = -Infinity;
    for (let i = 0; i < count; i++) {
      const at = i * 4;
      if (cones !== null && cones[at + 3] > -1) this.addCone(i, spheres, cones, projection, frame);
      else {
        const depth = -spheres[at + 2];
        const radius = spheres[at + 3];
        rectangle[0] = rectangle[1] = -Infinity;
        rectangle[2] = rectangle[3] = Infinity;
        this.add(i, spheres[at], spheres[at + 1], depth, radius, depth - radius, depth + radius, frame);
      }
    }
  }

  private addCone(
    i: number,
    spheres: ArrayLike<number>,
    cones: ArrayLike<number>,
    projection: ArrayLike<number>,
    frame: GridFrame,
  ): void {
    const at = i * 4;
    const x = spheres[at];
    const y = spheres[at + 1];
    const z = spheres[at + 2];
    const range = spheres[at + 3];
    const dx = -cones[at];
    const dy = -cones[at + 1];
    const dz = -cones[at + 2];
    const angle = Math.acos(cones[at + 3]);
    if (!projectedConeBounds(x, y, z, dx, dy, dz, range, angle, projection, rectangle)) return;
    coneBoundingSphere(x, y, z, dx, dy, dz, range, angle, sphere);
    const nearest = -z - coneSupport(dz, range, angle);
    const farthest = -z + coneSupport(-dz, range, angle);
    this.add(i, sphere[0], sphere[1], -sphere[2], sphere[3], nearest, farthest, frame);
  }

  /** Adds the part of a sphere that is inside `rectangle` and between the depths `first` and `last` (m). */
  private add(
    i: number,
    centreX: number,
    centreY: number,
    centreDepth: number,
    wholeRadius: number,
    first: number,
    last: number,
    frame: GridFrame,
  ): void {
    const { near, far, scaleX, scaleY, offsetX, offsetY, halfX, halfY } = frame;
    if (!(last >= near && first <= far)) return;
    let depth = centreDepth;
    let radius = wholeRadius;
    if (!(depth >= near && depth <= far)) {
      // less than half of the sphere is within near and far plane: a sphere around its disc on the plane contains that part
      depth = depth < near ? near : far;
      radius = halfChord(depth - centreDepth, radius);
    }
    const x = centreX * frame.signX;
    const y = centreY * frame.signY;
    let left = x - radius;
    let right = x + radius;
    let bottom = y - radius;
    let top = y + radius;
    if (frame.perspective) {
      if (depth - radius > near && depth + radius < far) {
        // as slopeBounds of an unclipped sphere, for x and y at once
        const squared = depth * depth - radius * radius;
        const rootX = radius * Math.sqrt(x * x + squared);
        const rootY = radius * Math.sqrt(y * y + squared);
        const inverse = 1 / squared;
        left = (x * depth - rootX) * inverse;
        right = (x * depth + rootX) * inverse;
        bottom = (y * depth - rootY) * inverse;
        top = (y * depth + rootY) * inverse;
      } else {
        slopeBounds(x, depth, radius, near, far, slopes);
        left = slopes[0];
        right = slopes[1];
        slopeBounds(y, depth, radius, near, far, slopes);
        bottom = slopes[0];
        top = slopes[1];
      }
    }
    left = Math.max(left * scaleX + offsetX, (rectangle[0] + 1) * halfX) - MARGIN;
    right = Math.min(right * scaleX + offsetX, (rectangle[2] + 1) * halfX) + MARGIN;
    const low = Math.max(bottom * scaleY + offsetY, (rectangle[1] + 1) * halfY) - MARGIN;
    const high = Math.min(top * scaleY + offsetY, (rectangle[3] + 1) * halfY) + MARGIN;
    if (!(right >= 0 && left <= 2 * halfX && high >= 0 && low <= 2 * halfY)) return;

    const n = this.count++;
    const { shapes, tiles } = this;
    const at = n * SHAPE;
    const nearest = first > near ? first : near;
    const farthest = last < far ? last : far;
    this.index[n] = i;
    shapes[at] = x;
    shapes[at + 1] = y;
    shapes[at + 2] = depth;
    shapes[at + 3] = radius;
    shapes[at + 4] = left;
    shapes[at + 5] = right;
    shapes[at + 6] = bottom;
    shapes[at + 7] = top;
    shapes[at + 8] = nearest;
    shapes[at + 9] = farthest;
    if (nearest < this.nearest) this.nearest = nearest;
    if (farthest > this.farthest) this.farthest = farthest;
    tiles[n * TILES] = left > 0 ? left : 0;
    tiles[n * TILES + 1] = Math.min(right, frame.tilesX - 1);
    tiles[n * TILES + 2] = low > 0 ? low : 0;
    tiles[n * TILES + 3] = Math.min(high, frame.tilesY - 1);
  }

  private reserve(count: number): void {
    this.index = new Uint32Array(count * 2);
    this.shapes = new Float64Array(count * 2 * SHAPE);
    this.tiles = new Uint16Array(count * 2 * TILES);
  }
}
