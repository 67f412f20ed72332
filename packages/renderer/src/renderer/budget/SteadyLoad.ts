/** Number of times or loads in a median. */
export const RECENT = 5;
const sorted = new Float64Array(RECENT);
/** Number of loads in the mean, at least and at most; and the relative error of the mean at which their number is enough. */
const [LEAST, MOST, DOUBT] = [6, 40, 0.02];
/** Smallest share by which the median of recent loads may differ from the mean before the mean begins anew. */
const JUMP = 0.12;
/** Standard deviations of a load by which the median may differ besides `JUMP`; a median of five has half of one. */
const JUMP_DEVIATIONS = 2.5;
/** Standard deviation of normally distributed values, as a share of the mean difference of two of them. */
const DEVIATION = 0.886;
/** Cap on the relative difference of successive loads, and weight of one difference in their running mean. */
const [MOST_CHANGE, CHANGE_WEIGHT] = [0.3, 1 / 24];
/** Weight that loads keep when the scale changes: they were measured at another one. */
const FADE = 0.8;
/** Part of the loads to remember with which a mean is steady: more or fewer are to be remembered as noise changes. */
const STEADY = 0.6;
/** Standard deviations by which a mean may be off. */
const CERTAINTY = 1.5;

/** Median of the last `most` values of a ring, of fewer where fewer were ever added. */
export function medianOfLast(ring: Float64Array, added: number, most: number): number {
  const number = Math.min(most, added);
  for (let i = 0; i < RECENT; i++) sorted[i] = i < number ? ring[(added - 1 - i + 2 * RECENT) % RECENT] : Infinity;
  sorted.sort();
  return sorted[(number - 1) >> 1];
}

/** Mean of a load that is measured with noise: a cost of frames, which begins anew where the load jumps. */
export class SteadyLoad {
  /** Mean cost (ms) of area 1; 0 until there are loads. */
  mean = 0;
  /** Loads that the mean is made of. */
  count = 0;
  private readonly recent = new Float64Array(RECENT);
  private added = 0;
  private last = 0;
  /** Mean share by which a load differs from the one before. */
  private change = 0.05;

  /** Whether the mean has all the loads that it remembers. */
  get isSteady(): boolean {
    return this.count >= STEADY * this.memory;
  }

  /** Standard deviation of a load, as a share of it. */
  get noise(): number {
    return DEVIATION * this.change;
  }

  /** Share by which the mean may be off. */
  get doubt(): number {
    return (CERTAINTY * this.noise) / Math.sqrt(Math.max(1, this.count));
  }

  /** @returns whether the mean began anew, since the load jumped */
  add(measured: number): boolean {
    this.recent[this.added++ % RECENT] = measured;
    const median = medianOfLast(this.recent, this.added, RECENT);
    // single frames that took far longer, or were interrupted, count as much as noise does
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

  /** Follows another measure of the load, in which all loads are `factor` times as large. */
  rescale(factor: number): void {
    this.mean *= factor;
    this.last *= factor;
    for (let i = 0; i < RECENT; i++) this.recent[i] *= factor;
  }

  /** Trusts the loads so far less: another scale begins, which the model of cost may not know. */
  fade(): void {
    this.count *= FADE;
  }

  /** Forgets all loads, and keeps how noisy they are. */
  restart(): void {
    this.mean = this.count = this.added = this.last = 0;
  }

  /** Loads to remember: the noisier, the more. */
  private get memory(): number {
    const needed = (CERTAINTY * this.noise) / DOUBT;
    return Math.min(Math.max(LEAST, Math.round(needed * needed)), MOST);
  }
}
