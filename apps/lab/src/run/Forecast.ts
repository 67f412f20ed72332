/** Time of a competitor in a case. */
interface Sample {
  value: number;
  ms: number;
}

/** Highest power of the value by which times grow: compilers take up to the square of the number of lights. */
const STEEPEST = 2;

/**
 * Predicts how long a competitor's frame takes in the next case of a series, so that cases of minutes are left out. The
 * last time is extrapolated by the power with which times grew between the last two cases, at most along the line
 * through their times. After a single case an ordinary frame is predicted in proportion to the value, and a first frame
 * by adding the ordinary frame's growth, since compiling and uploads do not depend on the value.
 */
export class Forecast {
  /** Frame times so far, in the order of the cases, by series, competitor and kind. */
  private readonly samples = new Map<string, Sample[]>();

  /** @param longest - predicted time (ms) beyond which a case is left out */
  constructor(private readonly longest: number) {}

  /**
   * Records a time.
   * @param kind - `first` or `frame`
   * @param value - the case's value along the axis
   * @param ms - measured time
   */
  note(series: string, competitor: string, kind: 'first' | 'frame', value: number, ms: number): void {
    const key = `${series} ${competitor} ${kind}`;
    const list = this.samples.get(key) ?? [];
    list.push({ value, ms });
    this.samples.set(key, list);
  }

  /** Reason to leave a case out, a sentence; null when there is none. */
  refuses(series: string, competitor: string, value: number): string | null {
    const key = `${series} ${competitor}`;
    const frame = this.predicted(`${key} frame`, value);
    const first = this.predictedFirst(key, value, frame);
    for (const [what, ms] of [['its first frame', first] as const, ['a frame', frame] as const]) {
      if (ms > this.longest) {
        return `Left out: ${what} would take about ${seconds(ms)}, by its growth so far (limit ${seconds(this.longest)}).`;
      }
    }
    return null;
  }

  private predictedFirst(key: string, value: number, frame: number): number {
    const firsts = this.samples.get(`${key} first`);
    if (!firsts || firsts.length > 1) return this.predicted(`${key} first`, value);
    const ordinary = this.samples.get(`${key} frame`)?.at(-1)?.ms ?? 0;
    return firsts[0].ms + Math.max(0, frame - ordinary);
  }

  private predicted(key: string, value: number): number {
    const list = this.samples.get(key);
    const last = list?.at(-1);
    if (!list || !last) return 0;
    const previous = list.at(-2);
    const slope =
      previous && previous.value > 0 && last.value > previous.value && previous.ms > 0
        ? Math.log(last.ms / previous.ms) / Math.log(last.value / previous.value)
        : 1;
    const growth = last.value > 0 ? Math.max(1, value / last.value) : 1;
    const byPower = last.ms * growth ** Math.min(STEEPEST, Math.max(0, slope));
    if (!previous || last.value <= previous.value) return byPower;
    // at most linear growth: two short times differ by chance, and their ratio squared would predict seconds
    const each = Math.max(0, last.ms - previous.ms) / (last.value - previous.value);
    return Math.min(byPower, last.ms + each * Math.max(0, value - last.value));
  }
}

const seconds = (ms: number): string => `${ms < 9950 ? (ms / 1000).toFixed(1) : Math.round(ms / 1000)} s`;
