const BYTES_PER_INDEX = Uint32Array.BYTES_PER_ELEMENT;

/** Runs of indices for one WEBGL_multi_draw call; adjoining runs are joined. */
export class TriangleRuns {
  /** Byte offset of each run's first index. */
  starts = new Int32Array(16);
  /** Number of indices in each run. */
  counts = new Int32Array(16);
  count = 0;

  clear(): void {
    this.count = 0;
  }

  /** Adds a run of vertex indices. @param first - place of the run in the index buffer @param indices - their number */
  add(first: number, indices: number): void {
    const { starts, counts, count } = this;
    const start = first * BYTES_PER_INDEX;
    if (count > 0 && starts[count - 1] + counts[count - 1] * BYTES_PER_INDEX === start) {
      counts[count - 1] += indices;
      return;
    }
    if (count === starts.length) this.grow();
    this.starts[count] = start;
    this.counts[count] = indices;
    this.count++;
  }

  private grow(): void {
    const starts = new Int32Array(this.starts.length * 2);
    const counts = new Int32Array(this.starts.length * 2);
    starts.set(this.starts);
    counts.set(this.counts);
    this.starts = starts;
    this.counts = counts;
  }
}
