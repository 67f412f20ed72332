import type { LabCase, LabSeries } from '../plan/LabPlan';
import type { LabRow } from '../results/LabRun';

/** State of a run before a step (opening a competitor, or its turn). The object is reused: copy what must be kept. */
export interface Progress {
  /** Number of finished steps. */
  done: number;
  /** Number of steps of the whole run. */
  total: number;
  /** Time left (ms), extrapolated from the steps so far; null during the first three. */
  remaining: number | null;
  /** Key of the current competitor; null between cases. */
  competitor: string | null;
  series: LabSeries;
  labCase: LabCase;
  /** Rows so far; rows of the current case change with each turn. */
  rows: readonly LabRow[];
  /** The picture that a competitor drew last; null before the first picture. */
  picture: ImageData | null;
}
