/** Number of lights in a row of the texture; the values of a row are uploaded together. */
const ROW = 128;

/**
 * Four numbers for each light of a LightField, with a version for each row. Call `update` after writing to `array`; each
 * renderer then uploads the rows of 128 lights changed since its last upload.
 */
export class LightArray {
  /** Values of the lights, [capacity, 4]. */
  readonly array: Float32Array<ArrayBuffer>;
  /** Version in which each row last changed. */
  private readonly rows: Uint32Array;
  private version = 1;
  /** Highest version in `rows`. */
  private newest = 1;

  /** @param capacity - number of lights */
  constructor(capacity: number) {
    const rows = Math.ceil(capacity / ROW);
    // rounded up to whole rows of the texture
    this.array = new Float32Array(rows * ROW * 4);
    this.rows = new Uint32Array(rows).fill(1);
  }

  /** Marks lights `first` to `first + count - 1` as changed. Default: all. */
  update(first = 0, count = Infinity): void {
    const last = Math.min(this.rows.length, Math.ceil((first + count) / ROW));
    for (let row = Math.max(0, Math.floor(first / ROW)); row < last; row++) this.rows[row] = this.version;
    this.newest = this.version;
  }

  /** Sets the four numbers of a light. */
  set(light: number, x: number, y: number, z: number, w: number): void {
    const { array } = this;
    const at = light * 4;
    array[at] = x;
    array[at + 1] = y;
    array[at + 2] = z;
    array[at + 3] = w;
    this.rows[light >> 7] = this.newest = this.version;
  }

  /** Whether one of the first `rows` changed after version `seen`. */
  hasChanged(seen: number, rows: number): boolean {
    if (this.newest <= seen) return false;
    for (let row = 0; row < rows; row++) if (this.rows[row] > seen) return true;
    return false;
  }

  /**
   * Calls `send` for each run among the first `rows` that changed after version `seen`.
   * @param seen - version returned by the last call for the same copy
   * @returns the version of the copy after the call
   */
  changes(seen: number, rows: number, send: (first: number, rows: number) => void): number {
    const versions = this.rows;
    for (let row = 0; row < rows; row++) {
      if (versions[row] <= seen) continue;
      const first = row;
      while (row < rows && versions[row] > seen) row++;
      send(first, row - first);
    }
    // later rows must still be uploaded
    for (let row = rows; row < versions.length; row++)
      if (versions[row] > seen) versions[row] = this.newest = this.version + 1;
    return this.version++;
  }

  /** @returns the version of a copy of the whole array */
  whole(): number {
    return this.version++;
  }
}
