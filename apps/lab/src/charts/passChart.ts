import { t } from '@farol/editing';
import type { LabRow, LabRun } from '../results/LabRun';
import { formatMs, formatNumber } from '../words/format';
import { isSoftware } from '../words/device';
import { competitorLabel, competitorWord } from '../words/names';
import { casesOf } from '../words/seriesCases';
import type { ChartSettings, ChartSpec } from './ChartSpec';
import { competitorOrder } from './competitorMarks';
import { type ChartRow, drawRows } from './drawRows';

/** Maximum number of passes with their own colour, the longest ones; others are summed. */
const MOST = 7;
const REST = 'other passes';

/**
 * A bar for each technique in one case, divided into the technique's passes; null if no passes were measured.
 * @param runs - all runs of the page, so that a pass has the same colour in each chart
 */
export function passChart(
  run: LabRun,
  settings: ChartSettings,
  key = 'passes',
  runs: readonly LabRun[] = [run],
): ChartSpec | null {
  const cases = casesOf(run).flatMap(({ series, index, label }) => {
    const rows = run.rows.filter((row) => row.series === series.name && row.index === index && passTotal(row) > 0);
    return rows.length > 0 ? [{ label, rows }] : [];
  });
  if (cases.length === 0) return null;
  const selected = Math.min(settings.cases[key] ?? cases.length - 1, cases.length - 1);
  const { label } = cases[selected];
  const rows = cases[selected].rows.toSorted((a, b) => competitorOrder(a.competitor) - competitorOrder(b.competitor));
  const isTimed = rows.every((row) => row.passes!.kind === 'gpu');
  const kind = !isTimed ? 'CPU' : isSoftware(run.surroundings.device) ? 'Rasteriser' : 'GPU';
  const names = passNames(runs.flatMap((each) => each.rows.filter((row) => passTotal(row) > 0)));
  const all = new Set(
    cases.flatMap((each) => each.rows.flatMap((row) => segments(row, names).map(({ name }) => name))),
  );
  const used = names.filter((name) => all.has(name));
  const most = Math.max(...rows.map(passTotal));
  const drawn = rows.map((row): ChartRow => {
    let from = 0;
    const total = passTotal(row);
    const bars = segments(row, names).map(({ name, ms }) => {
      const bar = { from, to: (from += ms), lane: 0, fill: fillOf(names, name), text: undefined as string | undefined };
      const share = formatNumber((ms / total) * 100, 2);
      return {
        ...bar,
        tip: {
          title: `${competitorLabel(row.competitor)}: ${t(name)}`,
          lines: [t('{time}, {share}% of {total}', { time: formatMs(ms), share, total: formatMs(total) })],
        },
      };
    });
    if (bars.length > 0) bars.at(-1)!.text = formatMs(total);
    return { label: competitorWord(row.competitor), competitor: row.competitor, bars };
  });
  return {
    key,
    title: t('Where a frame goes: {kind} time by pass', { kind: kind === 'Rasteriser' ? t('rasteriser') : kind }),
    description: t('{kind} milliseconds of each pass, stacked, a bar a technique; {case}.', {
      kind: t(kind),
      case: label,
    }),
    notes: [
      ...(kind === 'CPU' ? [t('Without a timer on the GPU, the CPU’s part of each pass is shown.')] : []),
      ...(kind === 'Rasteriser'
        ? [
            t(
              'A software rasteriser drew this run: its timers count time on the processor, which need not add up to a frame.',
            ),
          ]
        : []),
    ],
    table: {
      columns: [t('Technique'), ...used.map((name) => t(name)), t('Sum, ms')],
      rows: rows.map((row) => {
        const found = new Map(segments(row, names).map(({ name, ms }) => [name, ms]));
        const cells = used.map((name) => (found.has(name) ? formatNumber(found.get(name)!) : '–'));
        return [competitorLabel(row.competitor), ...cells, formatNumber(passTotal(row))];
      }),
    },
    keys: used.map((name) => ({ label: t(name), colour: fillOf(names, name) })),
    choice: { label: t('Case'), options: cases.map((each) => each.label), selected },
    draw: (options) =>
      drawRows(
        { rows: drawn, lanes: 1, type: 'linear', domain: [0, most], label: `${t(kind)} (ms)`, format: formatNumber },
        options,
      ),
  };
}

/** Names of the longest passes in drawing order, then a name for all others. */
function passNames(rows: readonly LabRow[]): string[] {
  const longest = new Map<string, number>();
  for (const row of rows) {
    const total = passTotal(row);
    for (const { name, ms } of row.passes!.passes) {
      if (ms > 0) longest.set(name, Math.max(longest.get(name) ?? 0, ms / total));
    }
  }
  if (longest.size <= MOST + 1) return [...longest.keys()];
  const kept = new Set(
    [...longest]
      .sort((a, b) => b[1] - a[1])
      .slice(0, MOST)
      .map(([name]) => name),
  );
  return [...[...longest.keys()].filter((name) => kept.has(name)), REST];
}

/** Sum of a row's pass times (ms); invalid times count as 0. */
export function passTotal(row: LabRow): number {
  return (row.passes?.passes ?? []).reduce((sum, { ms }) => sum + (Number.isFinite(ms) ? ms : 0), 0);
}

function segments(row: LabRow, names: readonly string[]): { name: string; ms: number }[] {
  const sums = new Map<string, number>();
  for (const { name, ms } of row.passes!.passes) {
    if (!(ms > 0)) continue;
    const key = names.includes(name) ? name : REST;
    sums.set(key, (sums.get(key) ?? 0) + ms);
  }
  return names.flatMap((name) => (sums.has(name) ? [{ name, ms: sums.get(name)! }] : []));
}

function fillOf(names: readonly string[], name: string): (paint: { shade(index: number): string }) => string {
  return (paint) => paint.shade(names.indexOf(name));
}
