import { type GridLights, SHAPE } from './GridLights';
import { NO_LIGHT } from './lightRecord';

export const BINS = 1024;
/** Number of bins in use with few lights, up to FEW: fewer bins to fill, and hardly more lights at a depth. */
const FEW_BINS = 256;
const FEW = 128;
/** Buckets of a bin, of the bucket sort of lights by depth. */
const KEYS_PER_BIN = 4;
/** Margin at both ends of each light's range (bins), since GPUs round depths. */
const MARGIN = 1 / 32;
/** Smallest range of depths that is divided into bins (units of the last place of a float). */
const LEAST_RANGE = 1 << 20;
/** Maximum number of deep lights, see `DepthBins`. */
const MOST_DEEP = 128;
const EXTENTS = 256;
/**
 * Number of lights in a page, which shaders read at once. Deep lights are sought if a depth reads, on average, LONG
 * times as many pages as it would if all lights had the mean `extent`.
 */
const PAGE = 128;
const LONG = 1.5;

/**
 * Orders lights by depth, divides depth into bins, and gives each bin the ranks of its first and its last light. The first and
 * the last bin have no lights. Bins widen with depth: with a float's bits as an integer, which grow like its logarithm,
 * `bin = clamp(int(float(floatBitsToInt(max(depth + shift, 0.0)) - start) * scale), 0, 1023)`.
 *
 * Deep lights, whose depths overlap those of far more lights than is usual, have the first ranks: they are in no bin and count
 * for every depth. In bins they would widen the range of each bin that they touch.
 * @see Drobot 2017, Improved Culling for Tiled and Clustered Rendering in Call of Duty: Infinite Warfare
 */
export class DepthBins {
  shift = 0;
  start = 0;
  scale = 0;
  /** One number for each bin: first rank | last rank << 16; first above last in a bin without lights. */
  readonly bins = new Uint32Array(BINS);
  /** Index in `GridLights` of the light of each rank; NO_LIGHT for ranks that fill the last word of deep lights. */
  order = new Uint32Array(0);
  /** Number of ranks (positions of lights in the order of depth) in use. */
  count = 0;
  /** Number of words (of 32 ranks) of deep lights. */
  deepWords = 0;
  /** Number of bins in use, from the first on; the others have no lights. */
  private used = BINS;
  private first = new Uint16Array(0);
  private last = new Uint16Array(0);
  private keys = new Uint16Array(0);
  private readonly starts = new Uint32Array(BINS * KEYS_PER_BIN + 1);
  private readonly countsBefore = new Uint32Array(BINS + 1);
  private readonly extents = new Uint32Array(EXTENTS);
  private readonly next = new Uint16Array(BINS + 1);

  /** @param perspective - whether all depths are above 0 */
  build(lights: GridLights, perspective: boolean): void {
    const { count } = lights;
    if (this.first.length < count) {
      this.first = new Uint16Array(count * 2);
      this.last = new Uint16Array(count * 2);
      this.keys = new Uint16Array(count * 2);
      this.order = new Uint32Array(count * 2 + 32);
    }
    if (count === 0) {
      this.count = this.deepWords = this.shift = this.start = this.scale = 0;
      this.bins.fill(0xffff);
      return;
    }
    this.used = count > FEW ? BINS : FEW_BINS;
    this.setScale(Math.max(lights.nearest, -1e30), Math.min(lights.farthest, 1e30), perspective);
    this.locate(lights);
    this.rank(count, Infinity);
    const cost = this.fillBins();
    const extent = this.countExtents(count);
    if (cost < LONG * (extent / PAGE + 1)) return;
    this.rank(count, this.deepLimit(count, extent));
    if (this.fillBins() > cost * 0.9) {
      this.rank(count, Infinity);
      this.fillBins();
    }
  }

  private setScale(nearest: number, farthest: number, perspective: boolean): void {
    // orthographic: the range of depths is shifted to where it spans one octave
    const size = Math.max(farthest - nearest, 0.01 * Math.max(Math.abs(nearest), Math.abs(farthest)), 1e-6);
    this.shift = perspective ? 0 : Math.fround(size - nearest);
    const start = floatBits(nearest + this.shift);
    const range = Math.max(floatBits(farthest + this.shift) - start, LEAST_RANGE);
    this.scale = Math.fround((this.used - 4) / range);
    this.start = start - Math.ceil(2 / this.scale);
  }

  /** Finds the bins and the key of each light. */
  private locate({ shapes, count }: GridLights): void {
    const { first, last, keys, countsBefore, shift, scale, start, used } = this;
    countsBefore.fill(0, 0, used + 1);
    for (let i = 0; i < count; i++) {
      const from = (floatBits(shapes[i * SHAPE + 8] + shift) - start) * scale;
      const to = (floatBits(shapes[i * SHAPE + 9] + shift) - start) * scale;
      first[i] = from - MARGIN;
      last[i] = Math.min(used - 2, to + MARGIN);
      const key = Math.min(used * KEYS_PER_BIN - 1, (from + to) * 2) | 0;
      keys[i] = key;
      countsBefore[(key >> 2) + 1]++;
    }
    for (let bin = 0; bin < used; bin++) countsBefore[bin + 1] += countsBefore[bin];
  }

  /** Counting sort: deep lights, of an extent above `limit`, then the other lights by the middle of their depths. */
  private rank(count: number, limit: number): void {
    const { keys, starts, order } = this;
    const buckets = this.used * KEYS_PER_BIN;
    starts.fill(0, 0, buckets + 1);
    let deep = 0;
    for (let i = 0; i < count; i++) {
      if (limit < count && this.extent(i) > limit) order[deep++] = i;
      else starts[keys[i] + 1]++;
    }
    this.deepWords = (deep + 31) >> 5;
    const padded = this.deepWords * 32;
    order.fill(NO_LIGHT, deep, padded);
    this.count = count - deep + padded;
    starts[0] = padded;
    for (let key = 0; key < buckets; key++) starts[key + 1] += starts[key];
    for (let i = 0; i < count; i++) {
      if (!(limit < count && this.extent(i) > limit)) order[starts[keys[i]]++] = i;
    }
  }

  /** Extent of a light: number of lights whose middle depth lies between its nearest and farthest depth. */
  private extent(i: number): number {
    return this.countsBefore[this.last[i] + 1] - this.countsBefore[this.first[i]];
  }

  /** Fills the histogram of the lights' extents. @returns the mean extent */
  private countExtents(count: number): number {
    const { extents } = this;
    let sum = 0;
    extents.fill(0);
    for (let i = 0; i < count; i++) {
      const extent = this.extent(i);
      sum += extent;
      extents[((extent / (count + 1)) * EXTENTS) | 0]++;
    }
    return sum / count;
  }

  /** Extent above which lights are deep: twice the mean, or more if that gave more than MOST_DEEP deep lights. */
  private deepLimit(count: number, mean: number): number {
    let step = EXTENTS;
    for (let deep = 0; step > 0; step--) {
      deep += this.extents[step - 1];
      if (deep > MOST_DEEP) break;
    }
    return Math.max(2 * mean, (step / EXTENTS) * (count + 1));
  }

  /** @returns the mean number of pages that are read for a depth */
  private fillBins(): number {
    const { bins, order, next, first, last, count, used } = this;
    const start = this.deepWords * 32;
    bins.fill(0xffff);
    // each bin is set once: `next` skips the bins that are set
    for (let bin = 0; bin <= used; bin++) next[bin] = bin;
    for (let rank = start; rank < count; rank++) {
      const end = last[order[rank]];
      for (let bin = follow(next, first[order[rank]]); bin <= end; bin = follow(next, bin)) {
        bins[bin] = rank;
        next[bin] = bin + 1;
      }
    }
    for (let bin = 0; bin <= used; bin++) next[bin] = bin;
    let pages = 0;
    for (let rank = count - 1; rank >= start; rank--) {
      const end = last[order[rank]];
      for (let bin = follow(next, first[order[rank]]); bin <= end; bin = follow(next, bin)) {
        pages += ((rank / PAGE) | 0) - ((bins[bin] / PAGE) | 0) + 1;
        bins[bin] |= rank << 16;
        next[bin] = bin + 1;
      }
    }
    return pages / used + Math.ceil(start / PAGE);
  }
}

const float = new Float32Array(1);
const bits = new Int32Array(float.buffer);

function floatBits(value: number): number {
  float[0] = value;
  return bits[0];
}

/** First bin at or after `bin` that has no value yet; shortens the chains in `next` (path halving). */
function follow(next: Uint16Array, bin: number): number {
  let at = bin;
  while (next[at] !== at) {
    next[at] = next[next[at]];
    at = next[at];
  }
  return at;
}
