import { t, tCount } from '@farol/editing';
import type { LabCase, LabSeries } from '../plan/LabPlan';
import { timeOf } from '../words/compareSpreads';
import type { LabRow, LabRun, Metric, Spread } from './LabRun';
import { caseKey } from './mergeRuns';

/** Times of a competitor in a case of both runs. */
export interface ComparedRow {
  readonly competitor: string;
  readonly series: LabSeries;
  readonly index: number;
  readonly value: number;
  /** Times of both runs; null unless both have one. */
  readonly times: readonly [a: Spread, b: Spread] | null;
  /** Medians of the two runs (ms); null for a run that did not measure the time. */
  readonly a: number | null;
  readonly b: number | null;
  /** a / b: over 1 if the second run is faster; null unless both runs measured the time. */
  readonly ratio: number | null;
}

/** Mean ratio of a competitor over all cases in which both runs measured it. */
export interface ComparedCompetitor {
  readonly competitor: string;
  /** Geometric mean of the ratios; null if there are none. */
  readonly ratio: number | null;
  readonly cases: number;
}

export interface ComparedRuns {
  /** Compared kind of time: by default GPU time if all measured rows have it, otherwise frame time. */
  readonly metric: Metric;
  readonly rows: readonly ComparedRow[];
  readonly competitors: readonly ComparedCompetitor[];
  /** Differences of the runs other than their device, each a sentence. */
  readonly differences: readonly string[];
}

/** Compares two runs row by row. Cases that draw the same picture are matched, whatever their series. */
export function compareRuns(a: LabRun, b: LabRun, metric: Metric = commonMetric(a, b)): ComparedRuns {
  const theirs = new Map<string, LabRow>();
  for (const row of b.rows) {
    const labCase = caseOf(b, row);
    if (labCase) theirs.set(`${row.competitor} ${caseKey(labCase)}`, row);
  }
  const rows: ComparedRow[] = [];
  for (const series of a.plan.series) {
    series.cases.forEach((labCase, index) => {
      for (const competitor of a.plan.competitors) {
        const ours = a.rows.find(
          (row) => row.series === series.name && row.index === index && row.competitor === competitor,
        );
        const their = theirs.get(`${competitor} ${caseKey(labCase)}`);
        if (!ours || !their) continue;
        const [first, second] = [timeOf(ours, metric), timeOf(their, metric)];
        rows.push({
          ...{ competitor, series, index, value: series.values[index] },
          times: first && second ? [first, second] : null,
          ...{ a: first?.median ?? null, b: second?.median ?? null },
          ratio: first && second ? first.median / second.median : null,
        });
      }
    });
  }
  const competitors = a.plan.competitors
    .map((competitor) => meanOf(competitor, rows))
    .filter(({ competitor }) => rows.some((row) => row.competitor === competitor));
  return { metric, rows, competitors, differences: differencesOf(a, b, rows.length) };
}

/** GPU time if all measured rows of both runs have it, otherwise frame time. */
function commonMetric(a: LabRun, b: LabRun): Metric {
  const drew = [...a.rows, ...b.rows].filter(({ frame }) => frame !== null);
  return drew.length > 0 && drew.every(({ gpu }) => gpu !== null) ? 'gpu' : 'frame';
}

function meanOf(competitor: string, rows: readonly ComparedRow[]): ComparedCompetitor {
  const ratios = rows.flatMap((row) => (row.competitor === competitor ? (row.ratio ?? []) : []));
  const logs = ratios.reduce((sum, ratio) => sum + Math.log(ratio), 0);
  return { competitor, ratio: ratios.length > 0 ? Math.exp(logs / ratios.length) : null, cases: ratios.length };
}

function differencesOf(a: LabRun, b: LabRun, compared: number): string[] {
  const found: string[] = [];
  const cases = (run: LabRun): Set<string> => new Set(run.plan.series.flatMap((each) => each.cases.map(caseKey)));
  const [ours, theirs] = [cases(a), cases(b)];
  const onlyOurs = [...ours].filter((each) => !theirs.has(each)).length;
  const onlyTheirs = [...theirs].filter((each) => !ours.has(each)).length;
  if (compared === 0) {
    found.push(
      differInSize(a, b)
        ? t('No picture has the same size in both runs: measure both at one size.')
        : t('The runs have no case and competitor in common: measure the same preset on both.'),
    );
  }
  if (onlyOurs > 0)
    found.push(
      tCount(
        onlyOurs,
        'One case of the first run alone is left out.',
        '{count} cases of the first run alone are left out.',
      ),
    );
  if (onlyTheirs > 0) {
    found.push(
      tCount(
        onlyTheirs,
        'One case of the second run alone is left out.',
        '{count} cases of the second run alone are left out.',
      ),
    );
  }
  const lacking = (from: LabRun, to: LabRun): string[] =>
    from.plan.competitors.filter((name) => !to.plan.competitors.includes(name));
  const [firstAlone, secondAlone] = [lacking(a, b), lacking(b, a)];
  if (firstAlone.length > 0) found.push(t('Only the first run measured {names}.', { names: firstAlone.join(', ') }));
  if (secondAlone.length > 0) found.push(t('Only the second run measured {names}.', { names: secondAlone.join(', ') }));
  const { effort: one } = a.plan;
  const { effort: two } = b.plan;
  if (one.rounds !== two.rounds || one.turn !== two.turn) {
    found.push(
      t('They took {a} turns of {aTime} ms and {b} of {bTime} ms.', {
        ...{ a: one.rounds, aTime: one.turn, b: two.rounds, bTime: two.turn },
      }),
    );
  }
  if (a.surroundings.build !== b.surroundings.build) {
    found.push(t('The builds of Farol differ: {a} and {b}.', { a: a.surroundings.build, b: b.surroundings.build }));
  }
  const names = Object.keys({ ...a.surroundings.versions, ...b.surroundings.versions });
  for (const name of names) {
    const [first, second] = [a.surroundings.versions[name], b.surroundings.versions[name]];
    if (first !== second && first && second)
      found.push(t('They have {name} {first} and {second}.', { name, first, second }));
  }
  if (a.surroundings.browser !== b.surroundings.browser) {
    found.push(t('The browsers differ: {a} and {b}.', { a: a.surroundings.browser, b: b.surroundings.browser }));
  }
  if (!a.complete) found.push(t('The first run ended before every case was measured.'));
  if (!b.complete) found.push(t('The second run ended before every case was measured.'));
  return found;
}

/** Whether the runs have cases that differ only in the size of the picture. */
function differInSize(a: LabRun, b: LabRun): boolean {
  const cases = ({ plan }: LabRun): LabCase[] => plan.series.flatMap((each) => each.cases);
  const [ours, theirs] = [cases(a), cases(b)].map(
    (list) => new Set(list.map((labCase) => caseKey({ ...labCase, width: 1, height: 1 }))),
  );
  return (
    a.plan.competitors.some((name) => b.plan.competitors.includes(name)) && [...ours].some((each) => theirs.has(each))
  );
}

function caseOf(run: LabRun, { series, index }: LabRow): LabCase | undefined {
  return run.plan.series.find(({ name }) => name === series)?.cases[index];
}
