import type { Footprint } from './footprint';

/** Occupancy of the texels of a square lightmap. */
export class TexelGrid {
  /**
   * One entry per texel, and one more, occupied, at each row's end. A free texel's entry is the number of free texels
   * in a row from it to the right; an occupied one's is minus a lower bound on the number of occupied texels in a row.
   */
  private readonly free: Int16Array;
  private readonly stride: number;
  /** Upper bound on the longest free run of each row. */
  private readonly longest: Int16Array;

  constructor(private readonly size: number) {
    this.stride = size + 1;
    this.free = new Int16Array(this.stride * size);
    this.longest = new Int16Array(size).fill(size);
    for (let row = 0; row < size; row++) {
      for (let column = 0; column < size; column++) this.free[row * this.stride + column] = size - column;
      this.free[row * this.stride + size] = -1;
    }
  }

  /**
   * First position, row by row, where a chart touches no occupied texel; -1 for none.
   *
   * @param from - position where the search begins
   * @returns row × (size + 1) + column of the chart's texel 0, 0
   */
  find({ width, height, touched }: Footprint, from: number): number {
    const { stride, free, longest } = this;
    const [rows, columns] = [this.size - height, this.size - width];
    let column = from % stride;
    for (let row = (from - column) / stride; row < rows; row++, column = 0) {
      if (longest[row + touched[0]] < touched[2]) continue;
      nextPlace: while (column < columns) {
        for (let i = 0; i < touched.length; i += 3) {
          const run = free[(row + touched[i]) * stride + column + touched[i + 1]];
          if (run >= touched[i + 2]) continue;
          // the search goes on to the right of the occupied texels
          column += run < 0 ? -run : run + 1;
          continue nextPlace;
        }
        return row * stride + column;
      }
    }
    return -1;
  }

  /** Marks the texels of a chart at a position, with its padding, as occupied. */
  take({ padded }: Footprint, place: number): void {
    const { size, stride, free } = this;
    const column = place % stride;
    const row = (place - column) / stride;
    for (let i = 0; i < padded.length; i += 3) {
      const y = row + padded[i];
      if (y < 0 || y >= size) continue;
      const first = Math.max(0, column + padded[i + 1]);
      const end = Math.min(size, column + padded[i + 1] + padded[i + 2]);
      const begin = y * stride;
      // number of occupied texels in a row, including those directly to the right
      let taken = Math.max(0, -free[begin + end]);
      for (let x = end - 1; x >= first; x--) free[begin + x] = -Math.min(++taken, 0x7fff);
      for (let x = first - 1; x >= 0 && free[begin + x] > 0; x--) free[begin + x] = first - x;
      this.measure(y);
    }
  }

  private measure(row: number): void {
    const { stride, free, size } = this;
    let most = 0;
    for (let at = row * stride, end = at + size; at < end;) {
      const run = free[at];
      if (run > most) most = run;
      at += run < 0 ? -run : run;
    }
    this.longest[row] = most;
  }
}
