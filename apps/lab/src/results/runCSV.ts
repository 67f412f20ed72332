import type { LabCase, LabSeries } from '../plan/LabPlan';
import type { LabRow, LabRun } from './LabRun';

type Cell = string | number | boolean | null;

interface Place {
  run: LabRun;
  series: LabSeries;
  labCase: LabCase;
  row: LabRow;
}

export interface Column {
  /** Heading of the column: lower snake case, with the unit at the end. */
  readonly name: string;
  readonly meaning: string;
  readonly cell: (place: Place) => Cell;
}

const column = (name: string, meaning: string, cell: (place: Place) => Cell): Column => ({ name, meaning, cell });

/** Median, percentiles and number of samples of a kind of time. */
function spreadColumns(kind: 'frame' | 'cpu' | 'gpu', what: string): Column[] {
  return [
    column(`${kind}_median_ms`, `${what}: median of the turns’ medians`, ({ row }) => row[kind]?.median ?? null),
    column(`${kind}_p10_ms`, '10th percentile of all samples', ({ row }) => row[kind]?.low ?? null),
    column(`${kind}_p90_ms`, '90th percentile of all samples', ({ row }) => row[kind]?.high ?? null),
    column(`${kind}_samples`, 'number of samples', ({ row }) => row[kind]?.samples ?? null),
  ];
}

const parametersText = ({ parameters }: LabCase['scene']): string =>
  Object.entries(parameters)
    .map(([name, value]) => `${name}=${value}`)
    .join(' ');

/** Columns of the CSV in their order. */
export const csvColumns: readonly Column[] = [
  column('run', 'identity of the run', ({ run }) => run.id),
  column('date', 'date and time of the run, ISO 8601', ({ run }) => run.surroundings.date),
  column('device', 'graphics device', ({ run }) => run.surroundings.device),
  column('browser', 'browser and its version', ({ run }) => run.surroundings.browser),
  column('system', 'operating system', ({ run }) => run.surroundings.system),
  column('build', 'version and commit of Farol', ({ run }) => run.surroundings.build),
  column('preset', 'preset, or custom', ({ run }) => run.plan.preset),
  column('series', 'name of the series', ({ series }) => series.name),
  column('case', 'index of the case in its series, from 0', ({ row }) => row.index),
  column('axis', 'property that varies along the series', ({ series }) => series.axis),
  column('value', 'value of the case along the axis', ({ series, row }) => series.values[row.index]),
  column('scene', 'scene', ({ labCase }) => labCase.scene.name),
  column('parameters', 'parameters of the scene, name=value', ({ labCase }) => parametersText(labCase.scene)),
  column('lights', 'moving lights; empty for a scene with its own', ({ labCase }) => labCase.lights),
  column('shadowed_lights', 'moving lights that cast shadows', ({ labCase }) => labCase.shadows),
  column('light_kind', 'kind of the moving lights', ({ labCase }) => labCase.lightKind),
  column('light_range_m', 'range of the moving lights; empty for the scene’s own', ({ labCase }) => labCase.lightRange),
  column('shading', 'shading of the materials', ({ labCase }) => labCase.shading),
  column('overdraw_layers', 'layers of quads over the picture', ({ labCase }) => labCase.overdraw),
  column('width_px', 'width of the picture', ({ labCase }) => labCase.width),
  column('height_px', 'height of the picture', ({ labCase }) => labCase.height),
  column('competitor', 'key of the competitor', ({ row }) => row.competitor),
  column('technique', 'technique chosen by the competitor', ({ row }) => row.technique),
  ...spreadColumns('frame', 'wall time of a frame in a batch'),
  ...spreadColumns('cpu', 'duration of the drawing call'),
  ...spreadColumns('gpu', 'GPU time by timer query'),
  column('first_ms', 'first frame, programs and uploads included', ({ row }) => row.firstMs),
  column('ten_lights_more_ms', 'frame after ten lights more', ({ row }) => row.added?.ms ?? null),
  column('ten_lights_more_programs', 'programs linked in it', ({ row }) => row.added?.programs ?? null),
  column('technique_changed_ms', 'frame after the technique changed', ({ row }) => row.changed?.ms ?? null),
  column('technique_changed_programs', 'programs linked in it', ({ row }) => row.changed?.programs ?? null),
  column('draws', 'draw calls of a frame', ({ row }) => row.counts?.draws ?? null),
  column('triangles', 'triangles of a frame', ({ row }) => row.counts?.triangles ?? null),
  column('programs', 'programs linked for the case', ({ row }) => row.counts?.programs ?? null),
  column('target_bytes', 'render targets and light data', ({ row }) => row.counts?.targetBytes ?? null),
  column('upload_bytes', 'sent to the device in a frame', ({ row }) => row.counts?.uploadBytes ?? null),
  column('reference', 'competitor that drew the reference picture', ({ row }) => row.likeness?.reference ?? null),
  column(
    'psnr_db',
    'PSNR to the reference picture; inf for an equal one',
    ({ row }) => row.likeness && (row.likeness.psnr ?? 'inf'),
  ),
  column('dropped_lights', 'lights that the competitor leaves out', ({ row }) => row.dropped),
  column('problem', 'reason why there is no figure', ({ row }) => row.problem),
  column('warnings', 'reasons why the figures are doubtful', ({ run, row }) =>
    [...run.surroundings.warnings, ...row.warnings].join(' '),
  ),
];

/**
 * A run as CSV by RFC 4180, UTF-8 without a byte order mark: a row for each case and competitor, an empty cell where
 * nothing was measured. A text that a spreadsheet would read as a formula gets an apostrophe in front.
 */
export function runCSV(run: LabRun): string {
  const series = new Map(run.plan.series.map((each) => [each.name, each]));
  const lines = [csvColumns.map(({ name }) => name)];
  for (const row of run.rows) {
    const planned = series.get(row.series);
    if (!planned) throw new Error(`Row of ${row.competitor}: the plan has no series "${row.series}".`);
    const place = { run, series: planned, labCase: planned.cases[row.index], row };
    lines.push(csvColumns.map(({ cell }) => cellText(cell(place))));
  }
  return lines.map((cells) => `${cells.join(',')}\r\n`).join('');
}

function cellText(cell: Cell): string {
  if (cell === null) return '';
  if (typeof cell !== 'string') return String(cell);
  const safe = /^[=+\-@\t\r]/.test(cell) ? `'${cell}` : cell;
  return /[",\r\n]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}
