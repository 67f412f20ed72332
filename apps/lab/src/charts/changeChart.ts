import { t, tCount } from '@farol/editing';
import type { Change, LabRow, LabRun } from '../results/LabRun';
import { timeOf } from '../words/compareSpreads';
import { formatMs, formatNumber } from '../words/format';
import { competitorLabel, competitorWord } from '../words/names';
import { casesOf } from '../words/seriesCases';
import type { ChartSettings, ChartSpec } from './ChartSpec';
import { competitorOrder } from './competitorMarks';
import { type ChartRow, drawRows, type RowBar } from './drawRows';

const kinds = ['First frame', 'Ten lights more', 'Technique changed'] as const;

/** Times of the first frame and of frames after changes in one case, three bars per competitor; null without any. */
export function changeChart(run: LabRun, settings: ChartSettings, key = 'changes'): ChartSpec | null {
  const cases = casesOf(run).flatMap(({ series, index, label }) => {
    const rows = run.rows.filter((row) => row.series === series.name && row.index === index && hasChange(row));
    return rows.length > 0 ? [{ label, rows }] : [];
  });
  // every run has first frames: without a frame after added lights or a changed technique there is no chart
  if (!cases.some(({ rows }) => rows.some(({ added, changed }) => added !== null || changed !== null))) return null;
  const selected = Math.min(settings.cases[key] ?? cases.length - 1, cases.length - 1);
  const { label } = cases[selected];
  const rows = cases[selected].rows.toSorted((a, b) => competitorOrder(a.competitor) - competitorOrder(b.competitor));
  const times = rows.flatMap((row) => [...timesOf(row).map((time) => time?.ms), timeOf(row, 'frame')?.median]);
  const known = times.filter((ms) => ms !== undefined);
  const isLog = settings.scale === 'log';
  const domain: [number, number] = isLog ? [Math.min(...known) / 1.5, Math.max(...known)] : [0, Math.max(...known)];
  const drawn = rows.map((row): ChartRow => {
    const usual = timeOf(row, 'frame');
    const bars = timesOf(row).flatMap((time, lane): RowBar[] => {
      if (time === null) return [];
      const programs = time.programs === null ? '' : `, ${programsText(time.programs)}`;
      const lines = [
        `${formatMs(time.ms)}${programs}`,
        ...(usual ? [t('An ordinary frame: {time}', { time: formatMs(usual.median) })] : []),
      ];
      const text = time.programs ? `${formatMs(time.ms)}, ${programsText(time.programs)}` : formatMs(time.ms);
      const tip = { title: `${competitorLabel(row.competitor)}: ${t(kinds[lane]).toLowerCase()}`, lines };
      return [
        {
          from: domain[0],
          to: time.ms,
          lane,
          fill: (paint) => paint.shade(lane),
          tip,
          text,
          shortText: formatMs(time.ms),
        },
      ];
    });
    return {
      label: competitorWord(row.competitor),
      competitor: row.competitor,
      bars,
      ticks: usual ? [usual.median] : [],
    };
  });
  return {
    key,
    title: t('What a change costs'),
    description: `${t('Milliseconds of the first frame, of the frame after ten lights more and of the frame after a change of technique, with programs linked; a line across each group is an ordinary frame.')} ${label}.`,
    table: {
      columns: [
        ...[t('Competitor'), t('Ordinary frame, ms')],
        ...kinds.flatMap((kind) => [`${t(kind)}, ms`, t('Programs')]),
      ],
      rows: rows.map((row) => [
        competitorLabel(row.competitor),
        formatNumber(timeOf(row, 'frame')?.median ?? Number.NaN),
        ...timesOf(row).flatMap((time) => [
          formatNumber(time?.ms ?? Number.NaN),
          formatNumber(time?.programs ?? Number.NaN),
        ]),
      ]),
    },
    keys: kinds.map((kind, i) => ({ label: t(kind), colour: (paint) => paint.shade(i) })),
    choice: { label: t('Case'), options: cases.map((each) => each.label), selected },
    draw: (options) =>
      drawRows(
        {
          ...{ rows: drawn, lanes: 3, type: settings.scale, domain, label: t('Frame (ms)'), format: formatNumber },
        },
        options,
      ),
  };
}

/** Times of the changes in `kinds`, in that order; null for a change that was not measured. */
function timesOf(row: LabRow): ({ ms: number; programs: number | null } | null)[] {
  const first = row.firstMs !== null && row.firstMs > 0 ? { ms: row.firstMs, programs: null } : null;
  return [first, changeOf(row.added), changeOf(row.changed)];
}

/** A change that has a time; null when it was not measured. */
function changeOf(change: Change | null): Change | null {
  return change !== null && Number.isFinite(change.ms) && change.ms > 0 ? change : null;
}

function hasChange(row: LabRow): boolean {
  return timesOf(row).some((time) => time !== null);
}

function programsText(programs: number): string {
  return tCount(programs, '{count} program', '{count} programs');
}
