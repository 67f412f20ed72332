/** Number of frame times, or of loads, of which a median is taken. */
export const RECENT = 5;
const sorted = new Float64Array(RECENT);
/** Minimum and maximum number of loads in the mean, and the relative error of the mean at which no more loads are needed. */
const [LEAST, MOST, DOUBT] = [6, 40, 0.02];
/** Smallest share by which the median of recent loads may differ from the mean before the mean begins anew. */
const JUMP = 0.12;
/** Number of standard deviations of a load, if above `JUMP`, by which the median of five loads may differ from the mean. */
const JUMP_DEVIATIONS = 2.5;
/** Standard deviation of normally distributed values, as a share of the mean difference of two of them. */
const DEVIATION = 0.886;
/** Cap on the relative difference of successive loads, and weight of one difference in their running mean. */
const [MOST_CHANGE, CHANGE_WEIGHT] = [0.3, 1 / 24];
/** Factor of the weight of earlier loads when the scale changes, since they were measured at another scale. */
const FADE = 0.8;
/** Share of `memory` that must be filled for the mean to be steady; below 1, since `memory` grows with noise. */
const STEADY = 0.6;
/** Number of standard deviations by which a mean may be off. */
const CERTAINTY = 1.5;

/** Median of the last `most` values of a ring, or of all while fewer were added. */
export function medianOfLast(ring: Float64Array, added: number, most: number): number {
  const number = Math.min(most, added);
  for (let i = 0; i < RECENT; i++) sorted[i] = i < number ? ring[(added - 1 - i + 2 * RECENT) % RECENT] : Infinity;
  sorted.sort();
  return sorted[(number - 1) >> 1];
}

/** Running mean of a noisy load (GPU or frame time a pixel), which begins anew where the load jumps. */
export class SteadyLoad {
  /** Mean load: time (ms) of the pixels at scale 1; 0 until there are loads. */
  mean = 0;
  /** Number of loads in the mean. */
  count = 0;
  private readonly recent = new Float64Array(RECENT);
  private added = 0;
  private last = 0;
  /** Mean share by which a load differs from the one before. */
  private change = 0.05;

  /** Whether the mean holds about as many loads as it is to remember. */
  get isSteady(): boolean {
    return this.count >= STEADY * this.memory;
  }

  /** Standard deviation of a load, as a share of it. */
  get noise(): number {
    return DEVIATION * this.change;
  }

  /** Relative error that the mean may have. */
  get doubt(): number {
    return (CERTAINTY * this.noise) / Math.sqrt(Math.max(1, this.count));
  }

  /** @returns whether the load jumped, so that the mean began anew */
  add(measured: number): boolean {
    this.recent[this.added++ % RECENT] = measured;
    const median = medianOfLast(this.recent, this.added, RECENT);
    // a single frame that took far longer, or was interrupted, counts no more than noise
    const off = Math.max(JUMP, JUMP_DEVIATIONS * this.noise);
    const load = Math.min(Math.max(measured, median / (1 + off)), median * (1 + off));
    if (this.last > 0) {
      const change = Math.min(MOST_CHANGE, Math.abs(load - this.last) / Math.max(this.mean, 1e-6));
      this.change += (change - this.change) * CHANGE_WEIGHT;
    }
    this.last = load;
    if (this.added >= 3 && Math.abs(median / this.mean - 1) > Math.max(JUMP, JUMP_DEVIATIONS * this.noise)) {
      this.mean = median;
      this.count = 3;
      return true;
    }
    this.count = Math.min(this.count + 1, this.memory);
    this.mean += (load - this.mean) / this.count;
    return false;
  }

  /** Multiplies all loads by `factor`, when the constant of the cost model changes. */
  rescale(factor: number): void {
    this.mean *= factor;
    this.last *= factor;
    for (let i = 0; i < RECENT; i++) this.recent[i] *= factor;
  }

  /** Lowers the weight of earlier loads: the scale changes, and the model of cost may be wrong for it. */
  fade(): void {
    this.count *= FADE;
  }

  /** Forgets all loads, and keeps how noisy they are. */
  restart(): void {
    this.mean = this.count = this.added = this.last = 0;
  }

  /** Number of loads to remember: more where they are noisier. */
  private get memory(): number {
    const needed = (CERTAINTY * this.noise) / DOUBT;
    return Math.min(Math.max(LEAST, Math.round(needed * needed)), MOST);
  }
}
