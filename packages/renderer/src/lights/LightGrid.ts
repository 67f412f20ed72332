import { DepthBins } from './DepthBins';
import { GridFrame } from './GridFrame';
import { GridInputs } from './GridInputs';
import { GridLights } from './GridLights';
import { NO_LIGHT } from './lightRecord';
import { TileMasks } from './TileMasks';

/** Maximum number of lights of a grid: ranks have 16 bits, and up to 31 may be unused. */
export const MOST_LIGHTS = 65_504;

/**
 * Which lights may reach which pixels: bit masks by tile of the picture, and ranges by depth.
 *
 *     picture, tiles of 32 pixels       depth, 1,024 bins that widen      lights in order of depth: ranks
 *     +----+----+----+----+             |0|1|2| 3  |  4   |    5    |     0 1 2 | 3 4 5 6 7 8 9 ...
 *     |    | A  | AB |  B |             eye                        far    deep  | by the middle of their depths
 *     +----+----+----+----+             light A: ====
 *     |    | A  | AB |  B |             light B:       ==========
 *     +----+----+----+----+
 *     mask of a tile: a bit a rank      bin: ranks of its first and its last light
 *
 *     lights of a pixel = bits of its tile's mask, at ranks from first to last of its depth's bin, and at deep ranks
 *
 * Tiles do not depend on depth, nor bins on the picture: memory grows with the sum of their numbers, not with the product
 * as for clusters. Lights that span far more depths than is usual are deep: they are in no bin and count for every depth.
 * No light that reaches a point is ever missing there; no list can overflow; arrays are allocated only to grow. Steps of
 * an update: `GridLights` (where each light is on screen), `DepthBins` (ranks and bins), `TileMasks` (bits).
 * @see Drobot 2017, Improved Culling for Tiled and Clustered Rendering in Call of Duty: Infinite Warfare
 */
export class LightGrid {
  /** Number of ranks (positions of lights in the order of depth) in use. */
  count = 0;
  /** Index of the light of each rank; NO_LIGHT for empty ranks. Only the first `count` are valid. */
  order = new Uint32Array(0);
  /** Number of updates that found other inputs than the update before. */
  changes = 0;
  private readonly inputs = new GridInputs();
  private readonly frame = new GridFrame();
  private readonly lights = new GridLights();
  private readonly tileMasks = new TileMasks();
  private readonly depthBins = new DepthBins();

  /** @param tileSize - side of a tile (pixels), above 0 */
  constructor(readonly tileSize = 32) {
    if (!(tileSize > 0)) throw new RangeError(`LightGrid: tileSize is ${tileSize}; give a size above 0.`);
  }

  get tilesX(): number {
    return this.frame.tilesX;
  }

  /** Rows of tiles; row 0 is the bottom of the picture. */
  get tilesY(): number {
    return this.frame.tilesY;
  }

  /** Number of 32-bit words of a tile, a multiple of 4. */
  get words(): number {
    return this.tileMasks.words;
  }

  /**
   * Word `w` of tile `(x, y)` at `((w >> 2) * tilesY * tilesX + y * tilesX + x) * 4 + (w & 3)`: a row of RGBA32UI
   * texels is a row of tiles, four words a texel. Only the first `tilesX * tilesY * words` are valid.
   */
  get masks(): Uint32Array {
    return this.tileMasks.masks;
  }

  /** First rank | last rank << 16 of each of 1,024 bins; first above last in a bin without lights. */
  get bins(): Uint32Array {
    return this.depthBins.bins;
  }

  /** Number of words, from the first on, whose lights count for every depth. */
  get deepWords(): number {
    return this.depthBins.deepWords;
  }

  /**
   * GLSL finds the bin of a depth, -z in view space (m), as
   * `clamp(int(float(floatBitsToInt(max(depth + depthShift, 0.0)) - depthStart) * depthScale), 0, 1023)`.
   */
  get depthShift(): number {
    return this.depthBins.shift;
  }

  /** Float bits of the first bin's depth, see `depthShift`; a whole number. */
  get depthStart(): number {
    return this.depthBins.start;
  }

  get depthScale(): number {
    return this.depthBins.scale;
  }

  /**
   * Computes masks and bins, unless all inputs equal those of the last update.
   * @param count - number of lights, up to MOST_LIGHTS
   * @param spheres - [count, 4] centre in view space and radius (m), finite centres; radius 0 to Infinity
   * @param projection - 16 elements, column-major: perspective, off-centre perspective or orthographic
   * @param near - depth of the near plane (m); above 0 for a perspective
   * @param far - depth of the far plane (m), or Infinity
   * @param width - width of the picture (pixels), with height
   * @param cones - [count, 4] unit vector from where the light shines to the light (view space), and the cosine of its cutoff, 0
   *   to 1; -1 for a sphere. Null: all are spheres
   * @throws RangeError for too many lights
   */
  update(
    count: number,
    spheres: ArrayLike<number>,
    projection: ArrayLike<number>,
    near: number,
    far: number,
    width: number,
    height: number,
    cones: ArrayLike<number> | null = null,
  ): void {
    if (count > MOST_LIGHTS) throw new RangeError(`LightGrid: ${count} lights; give ${MOST_LIGHTS} at most.`);
    if (!this.inputs.replace(count, spheres, projection, near, far, width, height, cones)) return;
    this.changes++;
    const { frame, lights, depthBins } = this;
    frame.set(projection, near, far, width, height, this.tileSize);
    lights.collect(count, spheres, cones, projection, frame);
    depthBins.build(lights, frame.perspective);
    this.tileMasks.fill(lights, depthBins.order, depthBins.count, frame);
    this.count = depthBins.count;
    if (this.order.length < this.count) this.order = new Uint32Array(depthBins.order.length);
    for (let rank = 0; rank < this.count; rank++) {
      const light = depthBins.order[rank];
      this.order[rank] = light === NO_LIGHT ? NO_LIGHT : lights.index[light];
    }
  }
}
