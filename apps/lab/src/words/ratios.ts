import type { LabRun, Metric } from '../results/LabRun';
import { caseKey as sameCase } from '../results/mergeRuns';
import { boundsOf, compareSpreads } from './compareSpreads';
import { entriesOf } from './rowsOf';
import { casesOf, type SeriesCase } from './seriesCases';

/** A competitor's time in a case of one run over its time in the same case of another. */
export interface Ratio {
  readonly competitor: string;
  readonly of: SeriesCase;
  readonly ratio: number;
  /** Lowest and highest ratio of the spreads' bounds. */
  readonly low: number;
  readonly high: number;
  readonly isTie: boolean;
}

/** Times of `run` over those of `base` in every case of both: same scene, lights and pixels. */
export function ratiosOf(run: LabRun, base: LabRun, metric: Metric): Ratio[] {
  const cases = new Map(casesOf(base).map((each) => [caseKey(each), each]));
  return casesOf(run).flatMap((of) => {
    const same = cases.get(caseKey(of));
    if (!same) return [];
    const baseTimes = new Map(
      entriesOf(base, same.series, same.index, metric).map(({ competitor, time }) => [competitor, time]),
    );
    return entriesOf(run, of.series, of.index, metric).flatMap(({ competitor, time }): Ratio[] => {
      const other = baseTimes.get(competitor);
      if (!other) return [];
      const [bounds, baseBounds] = [boundsOf(time), boundsOf(other)];
      return [
        {
          ...{
            competitor,
            of,
            ratio: time.median / other.median,
            low: bounds.low / baseBounds.high,
            high: bounds.high / baseBounds.low,
          },
          isTie: compareSpreads(time, other) === 0,
        },
      ];
    });
  });
}

const caseKey = ({ series, labCase }: SeriesCase): string => `${series.name} ${sameCase(labCase)}`;

/** Geometric mean of positive numbers. */
export function geometricMean(values: readonly number[]): number {
  return Math.exp(values.reduce((sum, value) => sum + Math.log(value), 0) / values.length);
}
