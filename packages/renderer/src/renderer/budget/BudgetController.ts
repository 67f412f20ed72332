import type { BudgetSource, FrameBudget } from '../FrameBudget';
import { REASONS } from './reasons';
import { Restlessness } from './Restlessness';
import { medianOfLast, RECENT, SteadyLoad } from './SteadyLoad';

/** Step of the scale from one frame to the next: too small to be seen. */
const STEP = 1 / 64;
/** Distance to the goal (steps) above which the scale changes by two steps a frame. */
const FAR = 8;
/** Share of the budget that predicted times aim at; the rest is for frames that take longer. */
const AIM = 0.98;
/**
 * Share of the budget, besides the doubt due to noise, by which the predicted time may be off `AIM` before the scale changes;
 * one step of the scale changes the time by less.
 */
const BAND = 0.06;
/** Value of `BAND` while the mean of the load is not steady yet, so that the goal follows new times sooner. */
const SEARCH_BAND = 0.03;
/** Factor by which the weight of earlier frames in the regression decays in each frame. */
const MEMORY = 0.95;
/**
 * Shares of the budget above which intervals are late, for a known and a new load; above 1, since a display's refresh may be a
 * little longer than the budget.
 */
const [LATE, NEW_LATE] = [1.07, 1.05];
/** Intervals below this share of the budget are a frame's own time; longer ones may be the display's refresh. */
const EARLY = 0.93;
/** Difference of intervals from the budget, as a share of it, above which the scale changes by two steps. */
const QUICK = 0.25;
/** Predicted share of the budget up to which a larger scale is tried, where intervals may be the display's refresh. */
const MOST = 1.06;
/** Number of punctual intervals after which a trial has succeeded, and up to which late frames are blamed on it. */
const [TRIAL, BLAME] = [8, 240];
/** Number of intervals before a larger scale is tried: at first; at least; after one failure; at most, after several. */
const [PACE, LEAST_PACE, PATIENCE, MOST_PATIENCE] = [30, 4, 60, 480];

/**
 * Finds the scale at which frames take the time of a budget, from times of frames and the scales that they were drawn at. A
 * frame is taken to cost load × (constant + scale²): the load is a running mean, over more frames where times are noisy, and the
 * constant is learnt by regression. Nothing changes while the prediction is within a band that grows with the noise. GPU times
 * predict the right scale; intervals that follow a display's refresh hide how much faster a frame was, so larger scales are
 * tried, less often after failures. The scale approaches its goal by one step a frame, by two from afar.
 */
export class BudgetController {
  reason: string = REASONS.unknown;
  /** Median of the last frame times (ms); null before the first. */
  ms: number | null = null;
  source: BudgetSource = 'interval';
  /** Number of steps below the largest scale: at present, and as a goal. */
  private step = 0;
  private goal = 0;
  private readonly steps: number;
  private readonly times = new Float64Array(RECENT);
  private count = 0;
  /** Cost that does not depend on the scale, as a share of that of the pixels at scale 1. */
  private constant = 0;
  /** Sums of the regression of times over areas: weight, x, y, xx, xy. */
  private readonly sums = new Float64Array(5);
  /** Cost of the pixels at scale 1 (ms). */
  private readonly load = new SteadyLoad();
  private readonly restlessness = new Restlessness();
  /** Number of punctual intervals since the scale changed, and since a larger scale was tried. */
  private inTime = 0;
  private sinceTrial = Infinity;
  /** Whether late frames were blamed on the last trial. */
  private blamed = false;
  /** Predicted time at the last punctual interval, as a share of the budget. */
  private usual = 0;
  /** Number of punctual intervals to wait before a larger scale is tried: usually, and after failures (0 for none). */
  private pace = PACE;
  private patience = 0;

  constructor(readonly budget: Required<FrameBudget>) {
    this.steps = Math.ceil((budget.max - budget.min) / STEP - 1e-6);
  }

  /** Scale of the next frame. */
  get scale(): number {
    return this.scaleOf(this.step);
  }

  /** Begins a frame: moves the scale a step towards its goal. @returns the frame's scale */
  advance(): number {
    const off = this.goal - this.step;
    if (off !== 0) this.load.fade();
    const most = this.source === 'interval' || Math.abs(off) > FAR ? 2 : 1;
    this.step += Math.sign(off) * Math.min(Math.abs(off), most);
    return this.scale;
  }

  /**
   * Adds the time of a frame. Very long times (a tab that slept, a shader that was compiled) and NaN are ignored.
   * @param scale - scale at which the frame was drawn
   */
  add(scale: number, ms: number, source: BudgetSource): void {
    const { frame } = this.budget;
    if (!(ms > 0) || ms > Math.max(500, 8 * frame)) return;
    if (source !== this.source) this.restart(source);
    // late frames of a failed trial do not count for the smaller scale
    if (this.blamed && scale !== this.scale) return;
    this.times[this.count++ % RECENT] = ms;
    this.ms = medianOfLast(this.times, this.count, RECENT);
    const area = scale * scale;
    if (this.load.add(ms / (this.constant + area))) this.sums.fill(0);
    if (this.count >= 3) this.learn(area, ms);
    this.restlessness.count(this.neededStep(area, ms));
    if (source === 'gpu') this.byTime();
    else this.byInterval();
  }

  private restart(source: BudgetSource): void {
    this.source = source;
    this.count = 0;
    this.load.restart();
    this.sums.fill(0);
  }

  private scaleOf(step: number): number {
    return Math.max(this.budget.min, this.budget.max - step * STEP);
  }

  private areaOf(step: number): number {
    return this.scaleOf(step) ** 2;
  }

  /** Predicted time of a frame at a step, as a share of the budget. */
  private share(step: number): number {
    return (this.load.mean * (this.constant + this.areaOf(step))) / this.budget.frame;
  }

  private byTime(): void {
    if (this.count < 3) return;
    const { load } = this;
    const off = this.share(this.step) - AIM;
    const band = load.isSteady ? BAND + load.doubt : SEARCH_BAND + load.doubt / 2;
    if (Math.abs(off) > band) {
      const goal = this.bestStep();
      // a steady load is corrected little by little
      const most = load.isSteady && this.goal === this.step ? 1 : Infinity;
      this.turn(Math.min(Math.max(goal, this.step - most), this.step + most));
    } else if (Math.abs(this.share(this.goal) - AIM) > band) this.goal = this.step;
    if (this.goal !== this.step) this.reason = off > 0 ? REASONS.slow : REASONS.fast;
    else if (off > band) this.reason = REASONS.smallest;
    else this.reason = off < -band ? REASONS.largest : REASONS.held;
  }

  /** Sets the goal; `restlessness` may hold back a larger scale. */
  private turn(goal: number): void {
    const { restlessness, step } = this;
    if (goal > step) restlessness.reduced(Math.max(0, goal - this.goal));
    else if (goal < step) {
      const begins = this.goal >= step;
      goal = begins ? Math.min(step, Math.max(goal, restlessness.leastFrom(step))) : Math.max(goal, this.goal);
      if (goal < Math.min(this.goal, step)) restlessness.enlarged(Math.min(this.goal, step) - goal);
    }
    this.goal = goal;
  }

  /** Step whose predicted time is nearest to the aimed one. */
  private bestStep(): number {
    return this.stepFor(this.load.mean);
  }

  /** Step that a frame needed; 0 for an interval that may be the display's refresh, since a larger scale might have held it. */
  private neededStep(area: number, ms: number): number {
    const share = ms / this.budget.frame;
    if (this.source === 'interval' && share > EARLY && share < LATE) return 0;
    return this.stepFor(ms / (this.constant + area));
  }

  /** Step at which a load takes the aimed time. */
  private stepFor(load: number): number {
    const scale = Math.sqrt(Math.max((AIM * this.budget.frame) / load - this.constant, 0));
    return Math.min(this.steps, Math.max(0, Math.round((this.budget.max - scale) / STEP)));
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
    const change =
      ((0.3 * spread) / (spread + 4 * this.load.noise ** 2)) * (Math.min(Math.max(constant, 0), 1) - this.constant);
    // rescaled so that load and constant still predict this frame's time
    this.load.rescale((this.constant + area) / (this.constant + change + area));
    this.constant += change;
  }

  private byInterval(): void {
    const { frame } = this.budget;
    if (this.count < 3 || this.goal !== this.step) return;
    const { isSteady } = this.load;
    const doubt = this.load.doubt / (isSteady ? 1 : 4);
    const share = this.share(this.step);
    const ms = medianOfLast(this.times, this.count, this.inTime > TRIAL ? RECENT : 3);
    // both must be late: the mean, which allows for noise, and the median, which a display's refresh does not blur
    if (share - doubt > (isSteady ? LATE : NEW_LATE) && ms > LATE * frame)
      return this.goLower(this.patience === 0 && share - doubt > 1 + QUICK ? 2 : 1);
    if (this.blamed) this.patience = Math.min(MOST_PATIENCE, Math.max(PATIENCE, 2 * this.patience));
    this.blamed = false;
    this.inTime++;
    this.sinceTrial++;
    if (this.sinceTrial === TRIAL && this.patience === 0) this.pace = Math.max(LEAST_PACE, this.pace >> 1);
    if (this.sinceTrial === BLAME) this.patience = 0;
    if (share < 0.75 * this.usual) this.patience = 0; // the load has fallen
    this.usual = share;
    const tells = share + doubt < EARLY;
    if (this.step === 0) this.reason = tells ? REASONS.largest : REASONS.held;
    else if (!tells) this.reason = REASONS.held;
    const hasRoom = this.step > 0 && this.share(this.step - 1) <= (tells ? 1 : MOST) - 2 * doubt;
    const pace = this.restlessness.isRestless ? PATIENCE : this.pace;
    const wait = Math.max(this.patience, tells ? 0 : pace);
    if (!hasRoom || this.inTime < wait || this.restlessness.leastFrom(this.step) >= this.step) return;
    this.turn(Math.max(0, this.step - (share + doubt < 1 - QUICK ? 2 : 1)));
    this.inTime = this.sinceTrial = 0;
    this.reason = tells ? REASONS.fast : REASONS.trial;
  }

  private goLower(steps: number): void {
    // blames a recent trial; if frames are late again after its step back, it was not to blame
    this.blamed = this.sinceTrial < BLAME && !this.blamed;
    if (this.blamed) {
      this.count = 0;
      this.load.restart();
    }
    this.pace = PACE;
    this.inTime = 0;
    this.sinceTrial = Infinity;
    this.turn(Math.min(this.steps, this.step + (this.blamed ? 1 : steps)));
    this.reason = this.goal === this.step ? REASONS.smallest : REASONS.slow;
  }
}
