/** Times of one competitor in one series, in the order of the cases. */
interface Seen {
  value: number;
  ms: number;
}

/** Steepest growth that is believed: time by the square of lights, as compilers have it. */
const STEEPEST = 2;

/**
 * Foretells how long a competitor's frame will take in the next case of a series, so that nobody waits for minutes: from
 * its last case, by the growth between its last two, and by no more than each light more has cost between these. After one, an ordinary frame is taken to grow in proportion; a first frame by as
 * much as that, since what it compiles and uploads beside is there with few lights too.
 */
export class Forecast {
  private readonly seen = new Map<string, Seen[]>();

  /** @param longest - time (ms) beyond which a case is left out */
  constructor(private readonly longest: number) {}

  /**
   * @param kind - `first` or `frame`
   * @param value - along the series' axis
   * @param ms - that it took
   */
  note(series: string, competitor: string, kind: 'first' | 'frame', value: number, ms: number): void {
    const key = `${series} ${competitor} ${kind}`;
    const list = this.seen.get(key) ?? [];
    list.push({ value, ms });
    this.seen.set(key, list);
  }

  /** Why a case is left out, as a sentence; null when it is not. */
  refuses(series: string, competitor: string, value: number): string | null {
    const key = `${series} ${competitor}`;
    const frame = this.foretold(`${key} frame`, value);
    const first = this.foretoldFirst(key, value, frame);
    for (const [what, ms] of [['its first frame', first] as const, ['a frame', frame] as const]) {
      if (ms > this.longest) {
        return `Left out: ${what} would take about ${seconds(ms)}, by its growth so far (limit ${seconds(this.longest)}).`;
      }
    }
    return null;
  }

  private foretoldFirst(key: string, value: number, frame: number): number {
    const firsts = this.seen.get(`${key} first`);
    if (!firsts || firsts.length > 1) return this.foretold(`${key} first`, value);
    const ordinary = this.seen.get(`${key} frame`)?.at(-1)?.ms ?? 0;
    return firsts[0].ms + Math.max(0, frame - ordinary);
  }

  private foretold(key: string, value: number): number {
    const list = this.seen.get(key);
    const last = list?.at(-1);
    if (!list || !last) return 0;
    const before = list.at(-2);
    const slope =
      before && before.value > 0 && last.value > before.value && before.ms > 0
        ? Math.log(last.ms / before.ms) / Math.log(last.value / before.value)
        : 1;
    const growth = last.value > 0 ? Math.max(1, value / last.value) : 1;
    const byPower = last.ms * growth ** Math.min(STEEPEST, Math.max(0, slope));
    if (!before || last.value <= before.value) return byPower;
    // two short times differ by chance: their ratio, at its square, foretells seconds
    const each = Math.max(0, last.ms - before.ms) / (last.value - before.value);
    return Math.min(byPower, last.ms + each * Math.max(0, value - last.value));
  }
}

const seconds = (ms: number): string => `${ms < 9950 ? (ms / 1000).toFixed(1) : Math.round(ms / 1000)} s`;
