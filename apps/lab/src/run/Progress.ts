import type { LabCase, LabSeries } from '../plan/LabPlan';
import type { LabRow } from '../results/LabRun';

/** What a run is doing, told before each step. The same object each time: read, do not keep. */
export interface Progress {
  /** Steps done, and in all. */
  done: number;
  total: number;
  /** Time left (ms), from how long the steps so far took; null in the first of them. */
  remaining: number | null;
  /** Key of the competitor at work, or null between cases. */
  competitor: string | null;
  series: LabSeries;
  labCase: LabCase;
  /** Rows so far; those of the case at work grow with its turns. */
  rows: readonly LabRow[];
  /** The picture that was drawn last, or null. */
  picture: ImageData | null;
}
