import type { BudgetSource, FrameBudget } from '../FrameBudget';
import { REASONS } from './reasons';

/** Change of the scale from one frame to the next: too little to be seen. */
const STEP = 1 / 64;
/** Steps from the goal above which a frame goes by two. */
const FAR = 8;
/** Share of the budget that predictions aim at: frames vary. */
const AIM = 0.96;
/** Share of the budget by which the predicted time may be off `AIM` before the scale changes: more than a step changes it. */
const BAND = 0.06;
/** Times that a median is taken of, and frames that a steady load is the mean of. */
const [TIMES, STEADY] = [5, 24];
/** Weight of earlier frames in the regression, a frame. */
const MEMORY = 0.95;
/** Share by which the median load may differ from the mean before that begins anew. */
const JUMP = 0.12;
/** Intervals above this share of the budget are too long: the display's refresh may lie just above it. */
const LATE = 1.1;
/** Intervals below this share of the budget tell how much faster a frame is, others may be the display's. */
const EARLY = 0.93;
/** Share of the budget up to which a larger scale is tried, by a prediction that does not know the display. */
const MOST = 1.06;
/** Intervals in time after which a trial has succeeded, and late ones up to which it is to blame. */
const [TRIAL, BLAME] = [8, 240];
/** Intervals before a larger scale is tried: at first and at least, after a failure and at most. */
const [PACE, LEAST_PACE, PATIENCE, MOST_PATIENCE] = [30, 4, 60, 480];

/**
 * Finds the scale at which frames take the time of a budget, from times of frames and the scales that they were drawn at. A
 * frame is taken to cost load × (constant + scale²): the load is the median of the last frames, the constant is learnt by
 * regression. The GPU's times tell the scale to go to; intervals of a display do not tell how much faster a frame was, so a
 * larger scale is tried, ever more seldom where it fails. The scale goes there by one step a frame, by two from afar.
 */
export class BudgetController {
  reason: string = REASONS.unknown;
  /** Median of the last times (ms); null until there are some. */
  ms: number | null = null;
  source: BudgetSource = 'interval';
  /** Steps below the largest scale: now, and to go to. */
  private step = 0;
  private goal = 0;
  private readonly steps: number;
  private readonly areas = new Float64Array(TIMES);
  private readonly times = new Float64Array(TIMES);
  private readonly sorted = new Float64Array(TIMES);
  private count = 0;
  /** Cost that does not depend on the scale, as a share of that of the pixels at scale 1. */
  private constant = 0;
  /** Sums of the regression of times over areas: weight, x, y, xx, xy. */
  private readonly sums = new Float64Array(5);
  /** Cost of the pixels at scale 1 (ms), as a mean of the last `loads` frames. */
  private load = 0;
  private loads = 0;
  /** Intervals in time since the scale changed, and since a larger one was tried. */
  private inTime = 0;
  private sinceTrial = Infinity;
  /** Whether the last trial may be why frames are late. */
  private blamed = false;
  /** Last median of the intervals in time (ms). */
  private usual = 0;
  /** Intervals in time before a larger scale is tried: in general, and after failures. */
  private pace = PACE;
  private patience = 0;

  constructor(readonly budget: Required<FrameBudget>) {
    this.steps = Math.ceil((budget.max - budget.min) / STEP - 1e-6);
  }

  /** Scale of the next frame. */
  get scale(): number {
    return this.scaleOf(this.step);
  }

  /** Begins a frame: goes on to the goal. @returns its scale */
  advance(): number {
    const off = this.goal - this.step;
    this.step += Math.sign(off) * (Math.abs(off) > FAR ? 2 : 1);
    return this.scale;
  }

  /**
   * Takes the time of a frame. One that took very long (a tab that slept, a shader that was compiled) does not count, nor one
   * that is no number.
   * @param scale - that it was drawn at
   */
  add(scale: number, ms: number, source: BudgetSource): void {
    const { frame } = this.budget;
    if (!(ms > 0) || ms > Math.max(500, 8 * frame)) return;
    if (source !== this.source) this.restart(source);
    // frames of a trial that failed are not held against the smaller scale
    if (this.blamed && scale !== this.scale) return;
    const at = this.count++ % TIMES;
    this.areas[at] = scale * scale;
    this.times[at] = ms;
    this.ms = this.median(TIMES, false);
    if (source === 'gpu') this.byTime(scale * scale, ms);
    else this.byInterval();
  }

  private restart(source: BudgetSource): void {
    this.source = source;
    this.count = 0;
    this.load = 0;
    this.sums.fill(0);
  }

  private scaleOf(step: number): number {
    return Math.max(this.budget.min, this.budget.max - step * STEP);
  }

  private areaOf(step: number): number {
    return this.scaleOf(step) ** 2;
  }

  /** @param loads - whether of the loads that the times tell, else of the times (ms) */
  private median(most: number, loads: boolean): number {
    const { sorted, times, areas, constant } = this;
    const number = Math.min(most, this.count);
    for (let i = 0; i < TIMES; i++) {
      const at = (this.count - 1 - i + 2 * TIMES) % TIMES;
      sorted[i] = i >= number ? Infinity : loads ? times[at] / (constant + areas[at]) : times[at];
    }
    sorted.sort();
    return sorted[(number - 1) >> 1];
  }

  private byTime(area: number, ms: number): void {
    const { frame } = this.budget;
    if (this.count < 3) return;
    const median = this.median(TIMES, true);
    if (Math.abs(median / this.load - 1) > JUMP) {
      this.load = median;
      this.loads = 3;
      this.sums.fill(0);
    } else {
      this.loads = Math.min(this.loads + 1, STEADY);
      this.load += (ms / (this.constant + area) - this.load) / this.loads;
      this.learn(area, ms);
    }
    const off = (this.load * (this.constant + this.areaOf(this.step))) / frame - AIM;
    if (Math.abs(off) > BAND) {
      const goal = this.stepFor((AIM * frame) / this.load - this.constant);
      // a steady load is corrected little by little
      const most = this.loads < STEADY || this.goal !== this.step ? Infinity : 1;
      this.goal = Math.min(Math.max(goal, this.step - most), this.step + most);
    } else if (Math.abs((this.load * (this.constant + this.areaOf(this.goal))) / frame - AIM) > BAND)
      this.goal = this.step;
    if (this.goal !== this.step) this.reason = off > 0 ? REASONS.slow : REASONS.fast;
    else if (off > BAND) this.reason = REASONS.least;
    else this.reason = off < -BAND ? REASONS.largest : REASONS.held;
  }

  /** Step whose area is the largest up to one. */
  private stepFor(area: number): number {
    const scale = Math.sqrt(Math.max(area, 0));
    return Math.min(this.steps, Math.max(0, Math.ceil((this.budget.max - scale) / STEP - 1e-6)));
  }

  /** Learns the constant, while the load is steady. */
  private learn(area: number, ms: number): void {
    const { sums } = this;
    for (let i = 0; i < 5; i++) sums[i] *= MEMORY;
    sums[0]++;
    sums[1] += area;
    sums[2] += ms;
    sums[3] += area * area;
    sums[4] += area * ms;
    const [n, x, y, xx, xy] = sums;
    const spread = xx / n - (x / n) ** 2;
    if (n < 4 || spread < 2e-3) return;
    const slope = (xy / n - (x / n) * (y / n)) / spread;
    if (slope <= 0) return;
    const constant = (y / n - (slope * x) / n) / slope;
    const change = 0.1 * (Math.min(Math.max(constant, 0), 1) - this.constant);
    // the load keeps telling the time of this frame
    this.load *= (this.constant + area) / (this.constant + change + area);
    this.constant += change;
  }

  private byInterval(): void {
    const { frame } = this.budget;
    if (this.count < 3 || this.goal !== this.step) return;
    const ms = this.median(this.inTime > TRIAL ? TIMES : 3, false);
    if (ms > LATE * frame) return this.goLower();
    if (this.blamed) this.patience = Math.min(MOST_PATIENCE, Math.max(PATIENCE, 2 * this.patience));
    this.blamed = false;
    this.inTime++;
    this.sinceTrial++;
    if (this.sinceTrial === TRIAL && this.patience === 0) this.pace = Math.max(LEAST_PACE, this.pace >> 1);
    if (this.sinceTrial === BLAME) this.patience = 0;
    if (ms < 0.75 * this.usual) this.patience = 0; // the load has fallen
    this.usual = ms;
    const tells = ms < EARLY * frame;
    if (this.step === 0) this.reason = tells ? REASONS.largest : REASONS.held;
    else if (!tells) this.reason = REASONS.held;
    const larger = (ms / this.areaOf(this.step)) * this.areaOf(this.step - 1);
    const wait = Math.max(this.patience, tells ? 0 : this.pace);
    if (this.step === 0 || this.inTime < wait || larger > (tells ? 1 : MOST) * frame) return;
    this.goal = this.step - 1;
    this.inTime = this.sinceTrial = 0;
    this.reason = tells ? REASONS.fast : REASONS.trial;
  }

  private goLower(): void {
    // a trial is to blame if its step back is enough
    this.blamed = this.sinceTrial < BLAME && !this.blamed;
    if (this.blamed) this.count = 0;
    this.pace = PACE;
    this.inTime = 0;
    this.sinceTrial = Infinity;
    this.goal = Math.min(this.steps, this.step + 1);
    this.reason = this.goal === this.step ? REASONS.least : REASONS.slow;
  }
}
