import type { LabRun, Metric } from '../results/LabRun';
import { caseKey as sameCase } from '../results/mergeRuns';
import { boundsOf, compareSpreads } from './compareSpreads';
import { formatFactor, formatNumber } from './format';
import { competitorWord } from './names';
import { entriesOf } from './rowsOf';
import { casesOf, type SeriesCase } from './seriesCases';

/** A competitor's time in a case of one run over its time in the same case of another. */
export interface Ratio {
  readonly competitor: string;
  readonly of: SeriesCase;
  readonly ratio: number;
  /** By the spreads' bounds. */
  readonly low: number;
  readonly high: number;
  readonly isTie: boolean;
}

/** Times of `run` over those of `base` in every case that both measured: same scene, lights and pixels. */
export function ratiosOf(run: LabRun, base: LabRun, metric: Metric): Ratio[] {
  const cases = new Map(casesOf(base).map((each) => [caseKey(each), each]));
  return casesOf(run).flatMap((of) => {
    const same = cases.get(caseKey(of));
    if (!same) return [];
    const before = new Map(
      entriesOf(base, same.series, same.index, metric).map(({ competitor, time }) => [competitor, time]),
    );
    return entriesOf(run, of.series, of.index, metric).flatMap(({ competitor, time }): Ratio[] => {
      const other = before.get(competitor);
      if (!other) return [];
      const [own, its] = [boundsOf(time), boundsOf(other)];
      return [
        {
          ...{ competitor, of, ratio: time.median / other.median, low: own.low / its.high, high: own.high / its.low },
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

/** How much longer one run takes than another: in all, and whose times differ least and most. */
export function ratioWords(ratios: readonly Ratio[], name: string, base: string): string[] {
  if (ratios.length === 0) return [`${name} and ${base} have no case in common.`];
  const all = geometricMean(ratios.map(({ ratio }) => ratio));
  const ties = ratios.filter(({ isTie }) => isTie).length;
  const count = ratios.length === 1 ? 'one figure' : `${formatNumber(ratios.length)} figures`;
  const overall = `${name} takes ${formatFactor(all)} as long as ${base}, over ${count} (geometric mean).`;
  const by = [...new Set(ratios.map(({ competitor }) => competitor))]
    .map((competitor) => ({
      competitor,
      mean: geometricMean(ratios.filter((each) => each.competitor === competitor).map(({ ratio }) => ratio)),
    }))
    .sort((a, b) => a.mean - b.mean);
  const sentences = [overall];
  if (by.length > 1) {
    const [least, most] = [by[0], by.at(-1)!];
    sentences.push(
      `Least: ${competitorWord(least.competitor)}, ${formatNumber(least.mean)} times; most: ${competitorWord(most.competitor)}, ${formatNumber(most.mean)} times.`,
    );
  }
  if (ties > 0) {
    sentences.push(
      ties === ratios.length
        ? 'No figure differs by more than the spread.'
        : `${ties} of the ${ratios.length} figures differ by no more than the spread.`,
    );
  }
  return sentences;
}
