import { Light } from '@farol/engine';
import { type Camera, type Matrix4, Vector3 } from 'three';
import { lightCount, type LightSource } from './lightSource';

/** Width of a tile of the light lists (pixels), as in the renderer's `LightGrid`. */
const TILE = 32;

/**
 * Cost per pixel of each type of light, relative to a point light. Area lights (rectangle, disc, tube) were measured
 * with 1,000 lights, see packages/renderer/docs/performance.md. Ambient and hemisphere lights share one sum.
 */
const weights: Readonly<Record<string, number>> = { ambient: 0, hemisphere: 0, rectangle: 4, disc: 6.4, tube: 3.7 };

/** Cost factor of a light with a shadow map (an estimate). */
const SHADOW = 2;

/** Picture that costs are estimated for. */
export interface CostView {
  readonly camera: Camera;
  /** Size of the picture (pixels). */
  readonly width: number;
  readonly height: number;
}

/** Number of tiles between two normalised device coordinates, along one side of the picture. */
function tilesAlong(low: number, high: number, tiles: number): number {
  const from = Math.floor(((Math.max(low, -1) + 1) / 2) * tiles);
  const to = Math.ceil(((Math.min(high, 1) + 1) / 2) * tiles);
  return Math.max(0, to - from);
}

/**
 * Range in normalised device coordinates of a sphere's outline along one axis, as tiles.
 * @param lateral - centre along the axis (m, view space), `depth` before the camera (m)
 * @see Mara and McGuire 2013, 2D Polyhedral Bounds of a Clipped, Perspective-Projected 3D Sphere
 */
function tilesOfAxis(
  lateral: number,
  depth: number,
  radius: number,
  scale: number,
  shift: number,
  tiles: number,
): number {
  const tangent = Math.sqrt(lateral * lateral + depth * depth - radius * radius);
  const [low, high] = [depth * tangent + lateral * radius, depth * tangent - lateral * radius];
  const from = low > 0 ? (lateral * tangent - depth * radius) / low : -Infinity;
  const to = high > 0 ? (lateral * tangent + depth * radius) / high : Infinity;
  return tilesAlong(from * scale + shift, to * scale + shift, tiles);
}

/** Number of tiles in the bounding rectangle of a sphere. @param centre - view space (m) */
export function tilesOfSphere(
  { x, y, z }: Vector3,
  radius: number,
  m: ArrayLike<number>,
  across: number,
  down: number,
): number {
  if (m[11] === 0) {
    const [i, j] = [m[0] * radius, m[5] * radius];
    const [u, v] = [x * m[0] + m[12], y * m[5] + m[13]];
    return tilesAlong(u - i, u + i, across) * tilesAlong(v - j, v + j, down);
  }
  if (radius - z <= 0) return 0;
  if (x * x + y * y + z * z <= radius * radius) return across * down;
  return tilesOfAxis(x, -z, radius, m[0], -m[8], across) * tilesOfAxis(y, -z, radius, m[5], -m[9], down);
}

const centre = new Vector3();
const axis = new Vector3();

/** Writes the centre of a light's bounds (world) to `centre`. @returns their radius (m); Infinity without a range */
function boundsOf(source: LightSource): number {
  const { matrixWorld } = source.gameObject.object3D;
  centre.setFromMatrixPosition(matrixWorld);
  if (!(source instanceof Light)) return source.lightRange;
  const { reach } = source;
  if (source.isArea) return reach + Math.hypot(source.width, source.height) / 2;
  if (source.type !== 'spot' || reach === Infinity) return reach;
  // smallest sphere around the cone of a spot light
  const { cutoff } = source;
  const isWide = cutoff > Math.PI / 4;
  const along = isWide ? reach * Math.cos(cutoff) : reach / (2 * Math.cos(cutoff));
  centre.addScaledVector(axis.setFromMatrixColumn(matrixWorld, 2).normalize(), -along);
  return isWide ? reach * Math.sin(cutoff) : along;
}

/** Maximum number of lights estimated in one task, so that frames are not delayed. */
const SLICE = 1000;

/**
 * Estimates the cost of each light for the GPU, as a share of the total: number of tiles that its bounds cover, times
 * the cost of its type, times `SHADOW` when it casts shadows. Ignores occlusion.
 */
export class CostEstimate {
  private readonly costs: Float64Array;
  private readonly toView: Matrix4;
  private readonly projection: readonly number[];
  private total = 0;
  private done = 0;

  /** @param sources - the lights; a light that is off costs nothing */
  constructor(
    private readonly sources: readonly LightSource[],
    private readonly view: CostView,
  ) {
    this.costs = new Float64Array(sources.length);
    this.toView = view.camera.matrixWorld.clone().invert();
    this.projection = [...view.camera.projectionMatrix.elements];
  }

  /** Estimates the next thousand lights. @returns shares in the order of the lights, 0 to 1; null until all are done */
  next(): Float64Array | null {
    const { sources, costs, view } = this;
    const [across, down] = [Math.ceil(view.width / TILE), Math.ceil(view.height / TILE)];
    const end = Math.min(sources.length, this.done + SLICE);
    for (; this.done < end; this.done++) {
      const source = sources[this.done];
      const cost = source.isActive ? this.tilesOf(source, across, down) * weightOf(source) : 0;
      costs[this.done] = cost;
      this.total += cost;
    }
    if (this.done < sources.length) return null;
    if (this.total > 0) for (let i = 0; i < costs.length; i++) costs[i] /= this.total;
    return costs;
  }

  private tilesOf(source: LightSource, across: number, down: number): number {
    const radius = boundsOf(source);
    if (radius === Infinity) return across * down;
    return tilesOfSphere(centre.applyMatrix4(this.toView), radius, this.projection, across, down);
  }
}

function weightOf(source: LightSource): number {
  if (!(source instanceof Light)) return lightCount(source);
  return (weights[source.type] ?? 1) * (source.castShadow ? SHADOW : 1);
}
