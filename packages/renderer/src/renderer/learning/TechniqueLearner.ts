import type { ChosenTechnique, SceneFigures } from '../warm-up/TechniqueChooser';
import { type LearntChoices, TIE, type Verdict } from './LearntChoices';

/** Number of frames from one trial to the next: 1 of 64 costs 1.6%. */
const INTERVAL = 64;
/** Number of frames from one trial to the next, once there is a verdict to check. */
const SETTLED_INTERVAL = 512;
/** Number of trials for a verdict; odd, for a median. */
const TRIALS = 15;
/** Share of the time by which a technique must be faster to win, or to replace the winner. */
const MARGIN = 0.08;
/** Factors of the chooser's bounds, nearest to 1 first; the choice is close where a factor changes it. */
const SCALES = [1, 2, 0.5, 4, 0.25];

/** Order of techniques in keys; part of the stored version. */
const order: readonly ChosenTechnique[] = [
  'forward-single-pass',
  'clustered-forward',
  'clustered-deferred',
  'tiled-deferred',
  'forward-plus',
];
/** Factor of the first technique of a pair in keys. */
const PAIR = 8;

/** A verdict of 'auto' on a GPU: the faster of two techniques, for frames with one to two times the figures given here. */
export interface LearntChoice {
  /** Device by WEBGL_debug_renderer_info. */
  readonly gpu: string;
  readonly techniques: readonly [ChosenTechnique, ChosenTechnique];
  /** Faster technique; null where neither is faster by 8%. */
  readonly faster: ChosenTechnique | null;
  readonly lights: number;
  /** Mean number of lights over a pixel. */
  readonly coverage: number;
  /** Estimated number of shadings of a pixel; 1 unless one of the two techniques draws depth first. */
  readonly overdraw: number;
  /** Number of pixels of the picture. */
  readonly pixels: number;
}

/** A stored verdict in words, see {@link TechniqueLearner.keyOf}. */
export function readVerdict(gpu: string, key: number, verdict: Verdict): LearntChoice {
  const digit = (place: number): number => Math.floor(key / 32 ** place) % 32;
  const pair = Math.floor(key / 32 ** 4);
  const techniques = [order[Math.floor(pair / PAIR)], order[pair % PAIR]] as const;
  return {
    ...{ gpu, techniques, faster: verdict === TIE ? null : techniques[verdict] },
    ...{ lights: 2 ** digit(3), coverage: 2 ** digit(2), overdraw: 2 ** digit(1), pixels: 2 ** digit(0) },
  };
}

/** Times of trials without a verdict so far: cost of the pair's second technique over that of its first. */
interface Trials {
  readonly ratios: Float64Array;
  count: number;
}

/** The rule of 'auto', its bounds widened or narrowed by a factor. */
interface Rule {
  best(figures: SceneFigures, scale: number): ChosenTechnique;
}

/**
 * Learns from timed trials which of two techniques is faster on a GPU, for similar numbers of lights, lights a pixel and pixels.
 * A verdict takes fifteen trials and a difference of 8%; later trials check it. Lookups allocate nothing.
 */
export class TechniqueLearner {
  private readonly trials = new Map<number, Trials>();
  /** Number of draws since the last trial. */
  private draws = 0;

  constructor(readonly learnt: LearntChoices) {}

  /**
   * Technique that the rule would pick with slightly other bounds; null where its choice of `technique` is clear.
   * @param multisampled - whether to allow only rivals with the same edges: both with a G-buffer, or both without
   */
  rivalOf(
    technique: ChosenTechnique,
    rule: Rule,
    figures: SceneFigures,
    multisampled: boolean,
  ): ChosenTechnique | null {
    for (let i = 0; i < SCALES.length; i++) {
      const rival = rule.best(figures, SCALES[i]);
      if (rival !== technique && (!multisampled || isDeferred(rival) === isDeferred(technique))) return rival;
    }
    return null;
  }

  /** Key of an unordered pair of techniques and of figures rounded to powers of two. */
  keyOf(one: ChosenTechnique, other: ChosenTechnique, figures: SceneFigures): number {
    const i = order.indexOf(one);
    const j = order.indexOf(other);
    const lights = steps(figures.bounded + figures.everywhere);
    const coverage = steps(figures.coverage + figures.everywhere);
    const overdraw = one === 'forward-plus' || other === 'forward-plus' ? steps(1 + figures.overdraw) : 0;
    const pair = Math.min(i, j) * PAIR + Math.max(i, j);
    return (((pair * 32 + lights) * 32 + coverage) * 32 + overdraw) * 32 + steps(figures.pixels);
  }

  /** Faster technique of a pair, as learnt; without a verdict `technique`, which the rule picked. */
  fasterOf(technique: ChosenTechnique, rival: ChosenTechnique, key: number): ChosenTechnique {
    const verdict = this.learnt.get(key);
    if (verdict === undefined || verdict === TIE) return technique;
    const isFirst = order.indexOf(technique) < order.indexOf(rival);
    return isFirst === (verdict === 0) ? technique : rival;
  }

  /** Counts a draw. @returns whether a trial of the pair is due */
  isDue(key: number): boolean {
    return ++this.draws >= (this.learnt.get(key) === undefined ? INTERVAL : SETTLED_INTERVAL);
  }

  /** Notes that a trial is drawn. */
  begin(): void {
    this.draws = 0;
  }

  /**
   * Adds the times (ms) of a trial: a draw by each of two techniques. Times that are no numbers above 0 do not count.
   * @returns whether this led to a verdict other than the one before
   */
  add(key: number, one: ChosenTechnique, oneTime: number, other: ChosenTechnique, otherTime: number): boolean {
    const ratio = order.indexOf(one) < order.indexOf(other) ? otherTime / oneTime : oneTime / otherTime;
    if (!(ratio > 0 && ratio < Infinity)) return false;
    let trials = this.trials.get(key);
    if (trials === undefined) this.trials.set(key, (trials = { ratios: new Float64Array(TRIALS), count: 0 }));
    trials.ratios[trials.count++] = ratio;
    if (trials.count < TRIALS) return false;
    this.trials.delete(key);
    const median = trials.ratios.sort()[(TRIALS - 1) / 2];
    const before = this.learnt.get(key);
    const verdict = median < 1 - MARGIN ? 1 : median > 1 / (1 - MARGIN) ? 0 : (before ?? TIE);
    if (verdict === before) return false;
    this.learnt.set(key, verdict);
    return true;
  }

  /** Forgets all that was learnt. */
  clear(): void {
    this.trials.clear();
    this.learnt.clear();
  }
}

/** Number of doublings from 1 to a value, 0 to 31. */
const steps = (value: number): number => Math.min(31, Math.floor(Math.log2(Math.max(1, value))));

const isDeferred = (technique: ChosenTechnique): boolean => technique.endsWith('deferred');
