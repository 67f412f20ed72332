import type { LightGrid } from './LightGrid';

/** Inputs of the last update of a light grid, in arrays that only grow. */
export class GridInputs {
  private count = -1;
  private hasCones = false;
  /** Projection matrix (16 numbers), near and far (m), width and height (pixels). */
  private readonly view = new Float64Array(20);
  private spheres = new Float64Array(0);
  private cones = new Float64Array(0);

  /**
   * Compares inputs with those of the last update, and stores them; parameters as for `LightGrid.update`.
   * @returns whether one differs
   */
  readonly replace: (...inputs: Required<Parameters<LightGrid['update']>>) => boolean = (
    count,
    spheres,
    projection,
    near,
    far,
    width,
    height,
    cones,
  ) => {
    const { view } = this;
    let differs = count !== this.count || (cones !== null) !== this.hasCones;
    differs = replaceOne(view, 16, near) || differs;
    differs = replaceOne(view, 17, far) || differs;
    differs = replaceOne(view, 18, width) || differs;
    differs = replaceOne(view, 19, height) || differs;
    differs = replaceAll(view, projection, 16) || differs;
    this.count = count;
    this.hasCones = cones !== null;
    if (this.spheres.length < count * 4) this.spheres = new Float64Array(count * 8);
    differs = replaceAll(this.spheres, spheres, count * 4) || differs;
    if (cones === null) return differs;
    if (this.cones.length < count * 4) this.cones = new Float64Array(count * 8);
    return replaceAll(this.cones, cones, count * 4) || differs;
  };
}

function replaceOne(kept: Float64Array, at: number, value: number): boolean {
  if (kept[at] === value) return false;
  kept[at] = value;
  return true;
}

/** Copies `count` values, beginning with the first that differs. @returns whether any differs */
function replaceAll(kept: Float64Array, values: ArrayLike<number>, count: number): boolean {
  let i = 0;
  while (i < count && kept[i] === values[i]) i++;
  const differs = i < count;
  for (; i < count; i++) kept[i] = values[i];
  return differs;
}
