import { t } from '@farol/editing';
import { logTicks } from '../charts/scales';
import type { ChartSettings, ChartSpec, ChartTip } from '../charts/ChartSpec';
import { type ChartRow, drawRows, type RowBar, type RowMark } from '../charts/drawRows';
import type { LabRun } from '../results/LabRun';
import { formatMs, formatNumber } from '../words/format';
import { isSoftware } from '../words/device';
import { byMetric, competitorLabel, competitorWord, isTechnique } from '../words/names';
import { compareThesis, type ThesisPair, timeIn } from './compareThesis';
import type { Frames } from './thesis2015';

const headings = { planes: 'N × N planes, M × M lights', sponza: 'Sponza (here: atrium)', temple: 'Temple' } as const;
/** Competitors comparable with the thesis's forward rendering; the first one uses the thesis's own algorithm. */
const forwards = ['multipass', 'forward', 'forward-single-pass', 'stock'];

/** Frame rates of the thesis beside a run's; null for CPU times, or if the run has too few of the thesis's rows. */
export function thesisChart(run: LabRun, settings: ChartSettings, key = 'thesis'): ChartSpec | null {
  // CPU time is that of the drawing call, from which no frame rate follows
  if (settings.metric === 'cpu') return null;
  const all = compareThesis(run, settings.metric);
  const measured = all.filter(({ entries }) => entries.length > 0);
  const isThesis = run.plan.preset === 'thesis';
  if (measured.length < (isThesis ? 1 : 3)) return null;
  const pairs = isThesis ? all : measured;
  const offered = forwards.filter((name) => measured.some((pair) => timeIn(pair, name)));
  const selected = Math.min(settings.cases[key] ?? 0, Math.max(0, offered.length - 1));
  const forward = offered[selected] ?? 'forward';
  const rows = rowsOf(pairs, forward);
  const values = rows.flatMap(({ bars, marks = [] }) => [
    ...bars.flatMap(({ from, to }) => [from, to]),
    ...marks.map(({ value }) => value),
  ]);
  const isLog = settings.scale === 'log';
  const domain: [number, number] = [isLog ? Math.min(...values) / 1.2 : 0, Math.max(...values) * 1.1];
  return {
    key,
    title: `${t('The thesis of 2015 and this run')}${byMetric(settings.metric)}`,
    description: t(
      'Frames a second of forward and deferred shading, row by row of the thesis’s three tables: pale bars are the ranges of 2015, symbols this run’s medians.',
    ),
    notes: [
      t(
        'Pale bars: the thesis, in a browser that showed 60 frames a second at most; where there is none, its counter could not follow. Symbols: this run, without a display to wait for.',
      ),
      ...(isSoftware(run.surroundings.device)
        ? [t('A software rasteriser drew this run: it ranks the techniques on a processor, not on a GPU.')]
        : []),
    ],
    table: tableOf(pairs, forward),
    legend: [forward, 'deferred', 'auto'].filter((name) => measured.some((pair) => timeIn(pair, name))),
    choice:
      offered.length > 1
        ? { label: t('Forward is drawn by'), options: offered.map(competitorLabel), selected, exportsAll: true }
        : null,
    draw: (options) =>
      drawRows(
        {
          ...{ rows, lanes: 2, type: settings.scale, domain, label: t('Frames a second'), format: formatNumber },
          ticks: isLog ? (most) => logTicks(...domain, most) : undefined,
        },
        options,
      ),
  };
}

function rowsOf(pairs: readonly ThesisPair[], forward: string): ChartRow[] {
  const rows: ChartRow[] = [];
  let table = '';
  for (const pair of pairs) {
    if (pair.thesis.table !== table) rows.push({ label: t(headings[pair.thesis.table]), isHeading: true, bars: [] });
    table = pair.thesis.table;
    const tip = tipOf(pair, forward);
    const mark = (competitor: string, lane: number): RowMark[] => {
      const time = timeIn(pair, competitor);
      return time ? [{ value: 1000 / time.median, competitor, lane, tip }] : [];
    };
    rows.push({
      label: pair.label,
      bars: [...barOf(pair.thesis.forward, forward, 0, tip), ...barOf(pair.thesis.deferred, 'deferred', 1, tip)],
      marks: [...mark('auto', 1), ...mark(forward, 0), ...mark('deferred', 1)],
    });
  }
  return rows;
}

function barOf(frames: Frames, competitor: string, lane: number, tip: ChartTip): RowBar[] {
  if (frames === null) return [];
  // 3 % wider on both sides, so that the bar is visible even if both bounds are equal
  const [from, to] = [frames[0] * 0.97, frames[1] * 1.03];
  return [{ from, to, lane, opacity: 0.4, fill: (paint) => paint.competitor(competitor), tip }];
}

function tipOf(pair: ThesisPair, forward: string): ChartTip {
  const { thesis } = pair;
  const figures = [forward, 'deferred', 'auto'].flatMap((name) => {
    const time = timeIn(pair, name);
    return time ? [`${competitorLabel(name)}: ${rateText(time.median)}`] : [];
  });
  return {
    title: `${t(headings[thesis.table])}: ${pair.label}`,
    lines: [
      t('2015: forward {forward}, deferred {deferred}', {
        forward: framesText(thesis.forward),
        deferred: framesText(thesis.deferred),
      }),
      ...figures,
    ],
  };
}

function tableOf(pairs: readonly ThesisPair[], forward: string) {
  const cell = (pair: ThesisPair, name: string): string => {
    const time = timeIn(pair, name);
    return time ? rateText(time.median) : '–';
  };
  return {
    columns: [
      ...[t('Scene'), t('Forward, 2015'), t('Deferred, 2015'), competitorLabel(forward), competitorLabel('deferred')],
      ...[t('Fastest technique'), t('Its frames a second')],
    ],
    rows: pairs.map((pair) => {
      const best = pair.entries.find(({ competitor }) => isTechnique(competitor));
      return [
        `${t(headings[pair.thesis.table])}: ${pair.label}`,
        framesText(pair.thesis.forward),
        framesText(pair.thesis.deferred),
        cell(pair, forward),
        cell(pair, 'deferred'),
        best ? competitorWord(best.competitor) : '–',
        best ? rateText(best.time.median) : '–',
      ];
    }),
  };
}

function framesText(frames: Frames): string {
  if (frames === null) return t('could not be counted');
  return frames[0] === frames[1] ? `${frames[0]} FPS` : t('{low} to {high} FPS', { low: frames[0], high: frames[1] });
}

function rateText(ms: number): string {
  return `${formatNumber(1000 / ms)} FPS (${formatMs(ms)})`;
}
