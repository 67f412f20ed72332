import { formatCount, t } from '@farol/editing';
import { competitorNames } from '../../competitors/competitorNames';
import { type Axis, isNamed, type LabCase } from '../../plan/LabPlan';
import { lightKinds, shadingNames, shadings } from '../../plan/lightKinds';
import type { LabRow, LabRun, Spread } from '../../results/LabRun';
import { formatBytes, formatNumber } from '../../words/format';
import { competitorLabel, namedValue } from '../../words/names';
import { seriesLabel } from '../../words/seriesLabel';

export interface TableRow extends LabRow {
  readonly label: string;
  readonly seriesLabel: string;
  /** Index of the series in the plan. */
  readonly seriesIndex: number;
  /** Index of the competitor in the order of menus. */
  readonly competitorIndex: number;
  readonly labCase: LabCase;
  readonly axis: Axis;
  readonly value: number;
}

export interface RowColumn {
  readonly key: string;
  readonly label: string;
  readonly help: string;
  readonly isText?: boolean;
  /** Value to sort by; null comes last in both directions. */
  order(row: TableRow): number | null;
  text(row: TableRow): string;
}

const order = Object.keys(competitorNames);

/** Rows of a run with their cases. Rows whose series or case is not in the plan are left out. */
export function tableRows({ plan, rows }: Pick<LabRun, 'plan' | 'rows'>): TableRow[] {
  return rows.flatMap((row) => {
    const seriesIndex = plan.series.findIndex(({ name }) => name === row.series);
    const series = plan.series[seriesIndex];
    const labCase = series?.cases[row.index];
    if (!labCase) return [];
    const competitorIndex = order.indexOf(row.competitor);
    return {
      ...row,
      ...{ label: competitorLabel(row.competitor), seriesLabel: seriesLabel(series), seriesIndex, labCase },
      competitorIndex: competitorIndex < 0 ? order.length : competitorIndex,
      axis: series.axis,
      value: series.values[row.index],
    };
  });
}

const spread = (key: 'frame' | 'gpu' | 'cpu', label: string, help: string): RowColumn => ({
  ...{ key, label, help },
  order: (row) => row[key]?.median ?? null,
  text: (row) => spreadText(row[key]),
});

const figure =
  (format: (value: number) => string) =>
  (key: string, label: string, help: string, get: (row: TableRow) => number | null): RowColumn => ({
    ...{ key, label, help, order: get },
    text: (row) => {
      const value = get(row);
      return value === null ? '–' : format(value);
    },
  });
const number = figure(formatNumber);
const bytes = figure(formatBytes);

const change = (key: 'added' | 'changed', label: string, help: string): RowColumn => ({
  ...{ key, label, help },
  order: (row) => row[key]?.ms ?? null,
  text: (row) => {
    const one = row[key];
    if (!one) return '–';
    const programs = one.programs ? `, ${t('{count} compiled', { count: one.programs })}` : '';
    return `${formatNumber(one.ms)}${programs}`;
  },
});

const everyColumn: readonly RowColumn[] = [
  {
    ...{ key: 'case', label: 'Chart', help: 'Scene and axis.', isText: true },
    order: ({ seriesIndex, index }) => seriesIndex * 1000 + index,
    text: ({ seriesLabel }) => seriesLabel,
  },
  {
    ...{ key: 'value', label: 'Value', help: 'Value of the case along the x axis of its chart.' },
    order: ({ value }) => value,
    text: ({ axis, value }) => (isNamed(axis) ? namedValue(axis, value) : formatCount(value)),
  },
  {
    ...{ key: 'size', label: 'Picture', help: 'Width and height in pixels.' },
    order: ({ labCase }) => labCase.width * labCase.height,
    text: ({ labCase }) => `${labCase.width} × ${labCase.height}`,
  },
  {
    ...{
      key: 'lights',
      label: 'Lights',
      help: 'Moving lights: number, kind, range, and how many cast shadows.',
    },
    order: ({ labCase }) => labCase.lights,
    text: ({ labCase }) => {
      const { lights, lightKind, lightRange, shadows } = labCase;
      const parts = [lights === null ? t('its own') : formatCount(lights)];
      if (lightKind !== 'points') parts.push(t(lightKinds[lightKind].word));
      if (lightRange !== null) parts.push(`${lightRange} m`);
      if (shadows > 0) parts.push(t('{count} shadowed', { count: shadows }));
      return parts.join(', ');
    },
  },
  {
    ...{ key: 'shading', label: 'Shading', help: 'Shading of the materials, if not the scene’s own.' },
    order: ({ labCase }) => shadingNames.indexOf(labCase.shading) || null,
    text: ({ labCase }) => t(shadings[labCase.shading].label),
  },
  spread('frame', 'Frame (ms)', 'A whole frame: median, then the 10th and 90th percentile.'),
  spread('gpu', 'GPU (ms)', 'Time on the graphics device, by timer queries.'),
  spread('cpu', 'CPU (ms)', 'Duration of the drawing call.'),
  number('first', 'First frame (ms)', 'The first frame, with compiling and uploads.', (row) => row.firstMs),
  change('added', 'Ten lights more (ms)', 'The frame after ten lights were added.'),
  change('changed', 'Technique changed (ms)', 'The frame after another technique was chosen and this one again.'),
  number('draws', 'Draws', 'Draw calls of a frame.', ({ counts }) => counts?.draws ?? null),
  number('triangles', 'Triangles', 'Triangles of a frame.', ({ counts }) => counts?.triangles ?? null),
  number('programs', 'Programs', 'Shader programs compiled for the case.', ({ counts }) => counts?.programs ?? null),
  bytes('targets', 'Targets', 'Bytes of render targets and light data.', ({ counts }) => counts?.targetBytes ?? null),
  bytes('uploads', 'Uploads', 'Bytes sent to the device in a frame.', ({ counts }) => counts?.uploadBytes ?? null),
  {
    ...{
      key: 'psnr',
      label: 'Likeness (dB)',
      help: 'PSNR of the picture against the reference; higher is more alike.',
    },
    order: ({ likeness }) => (likeness ? (likeness.psnr ?? Infinity) : null),
    text: ({ likeness }) => psnrText(likeness),
  },
];

/** Columns in which any row has a value. @param rows - all rows of the run, filtered or not */
export function columnsOf(rows: readonly TableRow[]): RowColumn[] {
  return everyColumn.filter(
    (column) => column.isText || rows.length === 0 || rows.some((row) => column.order(row) !== null),
  );
}

/** A spread as `1.25 (1.19–1.4)`; a dash for none. */
export function spreadText(spread: Spread | null): string {
  if (!spread) return '–';
  return `${formatNumber(spread.median)} (${formatNumber(spread.low)}–${formatNumber(spread.high)})`;
}

/** Likeness of a picture to the reference (dB), `equal`, or a dash. */
export function psnrText(likeness: LabRow['likeness']): string {
  if (!likeness) return '–';
  return likeness.psnr === null ? t('equal') : likeness.psnr.toFixed(1);
}
