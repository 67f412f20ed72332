import type { Chart } from './chartsOf';

/** Horizontal runs of texels, three numbers each: row, first column, count. */
export type Runs = Int32Array;

/** Texels that a chart covers. Its UVs begin at the centre of texel 0, 0 and end at a texel centre. */
export interface Footprint {
  /** Width of its bounds in texels, from the first to the last texel centre. */
  readonly width: number;
  readonly height: number;
  /** Whether the chart is turned: u and v are exchanged. */
  readonly isTurned: boolean;
  /** Scale of u, in texels per metre; likewise `scaleV`. */
  readonly scaleU: number;
  readonly scaleV: number;
  /** Texels that the chart touches, the longest run first. */
  readonly touched: Runs;
  /** Touched texels and those within the padding; rows and columns may be negative. */
  readonly padded: Runs;
  /** Texels that the chart needs: those that it touches, and half of the padding around them. */
  readonly need: number;
}

/**
 * Computes the texels that a chart touches. The chart is stretched to whole texels, so that straight borders lie on
 * texel centres, and rotated so that its longer side lies along rows.
 *
 * @param uvs - UVs of the chart's surface (m)
 */
export function footprintOf(
  uvs: Float32Array,
  { triangles, left, bottom, width, height }: Chart,
  texelsPerMetre: number,
  padding: number,
): Footprint {
  const isTurned = height > width;
  const texels = (metres: number): number => Math.max(1, Math.round(metres * texelsPerMetre));
  const [texelsU, texelsV] = [texels(width), texels(height)];
  const [scaleU, scaleV] = [texelsU / Math.max(width, 1e-30), texelsV / Math.max(height, 1e-30)];
  const [columns, rows] = isTurned ? [texelsV, texelsU] : [texelsU, texelsV];
  const grid = new Uint8Array((columns + 1) * (rows + 1));
  const [x, y] = [new Float64Array(3), new Float64Array(3)];
  for (let i = 0; i < triangles.length; i += 3) {
    for (let k = 0; k < 3; k++) {
      const u = (uvs[2 * triangles[i + k]] - left) * scaleU;
      const v = (uvs[2 * triangles[i + k] + 1] - bottom) * scaleV;
      x[k] = isTurned ? v : u;
      y[k] = isTurned ? u : v;
    }
    touch(grid, columns + 1, rows + 1, x, y);
  }
  const touched = sortedRuns(grid, columns + 1, rows + 1, 0);
  const padded = sortedRuns(
    dilate(grid, columns + 1, rows + 1, padding),
    columns + 1 + 2 * padding,
    rows + 1 + 2 * padding,
    padding,
  );
  const need = (texelsOf(touched) + texelsOf(padded)) / 2;
  return { width: columns, height: rows, isTurned, scaleU, scaleV, touched, padded, need };
}

/** Marks the texels that a triangle touches. Texel 0, 0 has its centre at 0, 0. */
function touch(grid: Uint8Array, columns: number, rows: number, x: Float64Array, y: Float64Array): void {
  const first = Math.max(0, Math.round(Math.min(y[0], y[1], y[2])));
  const last = Math.min(rows - 1, Math.round(Math.max(y[0], y[1], y[2])));
  for (let row = first; row <= last; row++) {
    // clips the triangle to the lower and upper border of the row
    const [low, high] = [row - 0.5, row + 0.5];
    let [least, most] = [Infinity, -Infinity];
    const add = (at: number): void => {
      if (at < least) least = at;
      if (at > most) most = at;
    };
    for (let a = 0; a < 3; a++) {
      const b = a === 2 ? 0 : a + 1;
      if (y[a] >= low && y[a] <= high) add(x[a]);
      if (y[a] < low !== y[b] < low) add(x[a] + ((low - y[a]) / (y[b] - y[a])) * (x[b] - x[a]));
      if (y[a] < high !== y[b] < high) add(x[a] + ((high - y[a]) / (y[b] - y[a])) * (x[b] - x[a]));
    }
    if (least > most) continue;
    const [from, to] = [Math.max(0, Math.round(least)), Math.min(columns - 1, Math.round(most))];
    grid.fill(1, row * columns + from, row * columns + to + 1);
  }
}

/** A grid enlarged by `by` on all sides, in which all texels within `by` of a marked one are marked. */
function dilate(grid: Uint8Array, columns: number, rows: number, by: number): Uint8Array {
  const [wide, high] = [columns + 2 * by, rows + 2 * by];
  const along = new Uint8Array(wide * rows);
  for (let row = 0; row < rows; row++) {
    let until = -1;
    for (let column = 0; column < wide; column++) {
      if (column < columns && grid[row * columns + column] === 1) until = column + 2 * by;
      if (column <= until) along[row * wide + column] = 1;
    }
  }
  const all = new Uint8Array(wide * high);
  for (let column = 0; column < wide; column++) {
    let until = -1;
    for (let row = 0; row < high; row++) {
      if (row < rows && along[row * wide + column] === 1) until = row + 2 * by;
      if (row <= until) all[row * wide + column] = 1;
    }
  }
  return all;
}

function texelsOf(runs: Runs): number {
  let texels = 0;
  for (let i = 2; i < runs.length; i += 3) texels += runs[i];
  return texels;
}

function sortedRuns(grid: Uint8Array, columns: number, rows: number, origin: number): Runs {
  const runs: [number, number, number][] = [];
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      if (grid[row * columns + column] === 0) continue;
      const first = column;
      while (column < columns && grid[row * columns + column] === 1) column++;
      runs.push([row - origin, first - origin, column - first]);
    }
  }
  return Int32Array.from(runs.sort((a, b) => b[2] - a[2]).flat());
}
