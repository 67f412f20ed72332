import { isNamed, type LabCase, type LabSeries } from '../plan/LabPlan';
import { axisLabel, axisWords } from '../plan/sceneWords';
import { formatNumber } from '../words/format';
import { competitorLabel, namedValue } from '../words/names';
import type { LabRow, LabRun } from './LabRun';

/** A table of a series: each cell shows this quantity of one row of the run. */
interface Quantity {
  readonly title: string;
  readonly cell: (row: LabRow) => string | null;
  /** The quantity as a number: the lowest one among the rows of a case is printed bold. */
  readonly lowest?: (row: LabRow) => number | null;
}

const ms = (title: string, pick: (row: LabRow) => number | null | undefined): Quantity => {
  const lowest = (row: LabRow): number | null => pick(row) ?? null;
  return { title, lowest, cell: (row) => (lowest(row) === null ? null : digits(lowest(row))) };
};

const quantities: readonly Quantity[] = [
  ms('Milliseconds a frame: median of the turns’ medians, frames in batches', ({ frame }) => frame?.median),
  { title: 'Frames a second, from the same medians', cell: ({ frame }) => frame && digits(1000 / frame.median) },
  {
    title: 'Milliseconds a frame: 10th to 90th percentile of all samples',
    cell: ({ frame }) => frame && `${digits(frame.low)} to ${digits(frame.high)}`,
  },
  ms('GPU milliseconds a frame by timer query: median', ({ gpu }) => gpu?.median),
  ms('CPU milliseconds in the call that draws: median', ({ cpu }) => cpu?.median),
  ms('First frame (ms), programs and uploads included', ({ firstMs }) => firstMs),
  { title: 'The frame after ten lights more (ms; programs linked)', cell: ({ added }) => changeText(added) },
  { title: 'The frame after the technique changed (ms; programs linked)', cell: ({ changed }) => changeText(changed) },
  {
    title: 'Draw calls; programs; MB of render targets and light data',
    cell: ({ counts }) =>
      counts && [counts.draws, counts.programs, megabytes(counts.targetBytes)].map(digits).join('; '),
  },
  {
    title: 'Likeness to the reference picture: PSNR (dB); ∞ for an equal picture',
    cell: ({ likeness }) => likeness && (likeness.psnr === null ? '∞' : digits(likeness.psnr)),
  },
  {
    title: 'Technique that drew',
    cell: ({ technique, competitor }) => (technique === null || technique === competitor ? null : technique),
  },
];

/** A run as Markdown: surroundings, then tables as in chapter 4 of the thesis, with problems and warnings. */
export function runMarkdown(run: LabRun): string {
  const { plan, surroundings, rows } = run;
  const lines = [`# ${escaped(run.name || plan.label)}`, '', ...surroundingsLines(run)];
  for (const series of plan.series) {
    const seriesRows = rows.filter((row) => row.series === series.name);
    lines.push('', `## ${escaped(series.label)}`);
    if (seriesRows.length === 0) lines.push('', 'Nothing was measured.');
    for (const quantity of quantities) lines.push(...table(series, plan.competitors, seriesRows, quantity));
    lines.push(...remarks(series, seriesRows));
  }
  if (surroundings.warnings.length > 0) {
    lines.push('', '## Warnings', '', ...surroundings.warnings.map((each) => `- ${escaped(each)}`));
  }
  return `${lines.join('\n')}\n`;
}

function surroundingsLines({ surroundings, complete, duration, plan }: LabRun): string[] {
  const { date, device, browser, system, cores, build, versions, command } = surroundings;
  const turns = `${plan.effort.rounds} turns of ${digits(plan.effort.turn)} ms each`;
  const packages = Object.entries(versions).map(([name, version]) => `${name} ${version}`);
  return [
    `- Date: ${date}`,
    `- Device: ${escaped(device)}`,
    `- Browser: ${escaped(browser)}, ${escaped(system)}${cores === null ? '' : `, ${cores} cores`}`,
    `- Farol: ${escaped(build)}${packages.length > 0 ? `; ${escaped(packages.join(', '))}` : ''}`,
    `- Measured in ${digits(duration / 1000)} s, ${turns}${complete ? '' : '; ended before every case was measured'}`,
    ...(command === null ? [] : [`- Command: \`${command.replaceAll('`', '')}\``]),
  ];
}

function table(series: LabSeries, competitors: readonly string[], rows: LabRow[], quantity: Quantity): string[] {
  const { title, cell, lowest } = quantity;
  const columns = competitors.filter((name) => rows.some((row) => row.competitor === name && cell(row) !== null));
  if (columns.length === 0) return [];
  const heads = headings(series);
  const lines = [
    ...['', `${title}.`, ''],
    line([...heads.map(({ title }) => title), ...columns.map((name) => escaped(competitorLabel(name)))]),
    line([...heads, ...columns].map(() => '--:')),
  ];
  series.cases.forEach((labCase, index) => {
    const of = columns.map((name) => rows.find((row) => row.index === index && row.competitor === name));
    const numbers = of.flatMap((row) => (row && lowest ? (lowest(row) ?? []) : []));
    const lowestNumber = numbers.length > 1 ? Math.min(...numbers) : null;
    const cells = of.map((row) => {
      const text = row ? cell(row) : null;
      if (!row || text === null) return '–';
      return lowestNumber !== null && lowest?.(row) === lowestNumber ? `**${escaped(text)}**` : escaped(text);
    });
    lines.push(line([...heads.map(({ of }) => of(labCase, series.values[index])), ...cells]));
  });
  return lines;
}

/** Columns that identify a case: N × N planes and M × M lights as in the thesis, or the value along the axis. */
function headings(series: LabSeries): { title: string; of: (labCase: LabCase, value: number) => string }[] {
  const { axis, cases } = series;
  const squares = cases.every(
    ({ scene, lights }) => scene.name === 'benchmarkLights' && Number.isInteger(Math.sqrt(lights ?? 0.5)),
  );
  if (squares && (axis === 'lights' || axis === 'objects')) {
    return [
      { title: 'N × N planes', of: ({ scene }) => String(scene.parameters.n ?? '–') },
      { title: 'M × M lights', of: ({ lights }) => String(Math.sqrt(lights ?? 0)) },
    ];
  }
  if (axis === 'pixels') return [{ title: 'Pixels', of: ({ width, height }) => `${width} × ${height}` }];
  if (isNamed(axis)) return [{ title: axisWords[axis].label, of: (_, value) => namedValue(axis, value) }];
  return [{ title: axisLabel(series), of: (_, value) => digits(value) }];
}

/** Problems, warnings and numbers of lights left out, each with its case. */
function remarks(series: LabSeries, rows: LabRow[]): string[] {
  const found = rows.flatMap(({ competitor, index, problem, warnings, dropped }) => {
    const where = `${escaped(competitorLabel(competitor))}, ${whereText(series, index)}`;
    const dropping = dropped > 0 ? [`${digits(dropped)} lights are left out.`] : [];
    return [...(problem === null ? [] : [problem]), ...dropping, ...warnings].map(
      (each) => `- ${where}: ${escaped(each)}`,
    );
  });
  return found.length === 0 ? [] : ['', 'Problems and warnings:', '', ...found];
}

const whereText = ({ axis, values }: LabSeries, index: number): string =>
  isNamed(axis) ? namedValue(axis, values[index]) : `${digits(values[index])} ${axisWords[axis].unit}`;

/** A number, or a dash for none. */
const digits = (value: number | null | undefined): string => formatNumber(value ?? Number.NaN);

const changeText = (change: LabRow['added']): string | null =>
  change && `${digits(change.ms)}; ${digits(change.programs)}`;

const megabytes = (bytes: number | null): number | null => (bytes === null ? null : bytes / 1e6);

const line = (cells: readonly string[]): string => `| ${cells.join(' | ')} |`;

/** Escapes a text, which may come from a foreign file: one line without markup or cell borders. */
function escaped(text: string): string {
  return text.replaceAll(/\s+/g, ' ').replaceAll(/[\\`*_|<>[\]]/g, '\\$&');
}
