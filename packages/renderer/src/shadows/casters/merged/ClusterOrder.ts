/** Number of triangles in a cluster of merged casters. */
export const CLUSTER_TRIANGLES = 64;
/** Number of consecutive clusters in a group; they lie close together. */
export const CLUSTERS_PER_GROUP = 8;

/**
 * Orders the triangles of a geometry so that each `CLUSTER_TRIANGLES` consecutive ones lie close together: halves them at the
 * median along the axis on which their centres spread most, until each half is one cluster. `step` does a part of the work.
 * @see Bentley 1975, Multidimensional Binary Search Trees
 */
export class ClusterOrder {
  /** Indices of the triangles, in the new order. */
  readonly order: Uint32Array;
  /** Ranges of `order` still to be halved, as pairs of first and last (exclusive). */
  private readonly open: number[] = [];

  /** @param centres - centres of the triangles, 3 numbers each */
  constructor(private readonly centres: Float32Array) {
    const count = centres.length / 3;
    this.order = new Uint32Array(count);
    for (let i = 0; i < count; i++) this.order[i] = i;
    this.open.push(0, count);
  }

  get isDone(): boolean {
    return this.open.length === 0;
  }

  /**
   * Does a part of the sorting.
   * @param budget - triangles to visit, roughly
   * @returns triangles visited
   */
  step(budget: number): number {
    const { open } = this;
    let visited = 0;
    while (open.length > 0 && visited < budget) {
      const end = open.pop()!;
      const first = open.pop()!;
      const clusters = Math.ceil((end - first) / CLUSTER_TRIANGLES);
      if (clusters < 2) continue;
      const middle = first + Math.ceil(clusters / 2) * CLUSTER_TRIANGLES;
      this.select(this.longestAxis(first, end), first, end - 1, middle);
      open.push(first, middle, middle, end);
      visited += end - first;
    }
    return visited;
  }

  private longestAxis(first: number, end: number): number {
    const { centres, order } = this;
    let longest = 0;
    let most = -1;
    for (let axis = 0; axis < 3; axis++) {
      let low = Infinity;
      let high = -Infinity;
      for (let i = first; i < end; i++) {
        const value = centres[order[i] * 3 + axis];
        if (value < low) low = value;
        if (value > high) high = value;
      }
      if (high - low <= most) continue;
      most = high - low;
      longest = axis;
    }
    return longest;
  }

  /**
   * Moves centres with lower coordinates on an axis before `place`, those with higher ones after it (Hoare 1961, FIND).
   */
  private select(axis: number, first: number, last: number, place: number): void {
    const { centres, order } = this;
    while (first < last) {
      const pivot = centres[order[(first + last) >> 1] * 3 + axis];
      let i = first;
      let j = last;
      while (i <= j) {
        while (centres[order[i] * 3 + axis] < pivot) i++;
        while (centres[order[j] * 3 + axis] > pivot) j--;
        if (i > j) break;
        const swapped = order[i];
        order[i++] = order[j];
        order[j--] = swapped;
      }
      if (place <= j) last = j;
      else if (place >= i) first = i;
      else return;
    }
  }
}
