import { AGAINST, nameOf } from '../run/framesOfBuilds';
import { formatNumber } from '../words/format';
import { competitorLabel, valueText } from '../words/names';
import { compareRuns } from './compareRuns';
import type { LabRun } from './LabRun';

/** Splits a run of two builds into a run of each, this build's first; null for a run of one build. */
export function buildsOf(run: LabRun): [LabRun, LabRun] | null {
  const isOther = (name: string): boolean => name.endsWith(AGAINST);
  const others = run.plan.competitors.filter(isOther).map(nameOf);
  if (others.length === 0) return null;
  const plan = { ...run.plan, competitors: others };
  const rows = run.rows.filter(({ competitor }) => others.includes(competitor));
  const otherRows = run.rows
    .filter(({ competitor }) => isOther(competitor))
    .map((row) => ({ ...row, competitor: nameOf(row.competitor) }));
  return [
    { ...run, plan, rows },
    { ...run, plan, rows: otherRows },
  ];
}

/** Table in Markdown that compares the two builds of a run; empty for a run of one build. */
export function againstMarkdown(run: LabRun): string {
  const builds = buildsOf(run);
  if (!builds) return '';
  const { metric, rows, competitors } = compareRuns(...builds);
  const name = run.surroundings.versions.against ?? 'the other build';
  const number = (value: number | null): string => (value === null ? '–' : formatNumber(value));
  const lines = [
    ...['', `## This build against ${name.replaceAll(/[\\`*_|<>[\]]/g, '\\$&')}`, ''],
    ...[`Medians of ${metric} (ms); a ratio below 1: this build is faster.`, ''],
    ...['| case | competitor | this | other | ratio |', '| :-- | :-- | --: | --: | --: |'],
    ...rows.map(
      ({ series, labCase, value, competitor, a, b, ratio }) =>
        `| ${series.label}, ${valueText(series.axis, value, labCase)} | ${competitorLabel(competitor)} | ${number(a)} | ${number(b)} | ${number(ratio)} |`,
    ),
    ...competitors.map(
      ({ competitor, ratio, cases }) =>
        `| geometric mean of ${cases} cases | ${competitorLabel(competitor)} | | | **${number(ratio)}** |`,
    ),
  ];
  return `${lines.join('\n')}\n`;
}
