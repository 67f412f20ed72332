import { t } from '@farol/editing';
import { type LabCase, type LabPlan, type LabSeries, plainCase } from '../plan/LabPlan';
import { lightKindNames, shadingNames } from '../plan/lightKinds';
import {
  fields,
  FormatError,
  listOf,
  number,
  oneOf,
  orMissing,
  orNull,
  record,
  text,
  textLike,
  whole,
  yesOrNo,
  type Check,
} from './checks';
import {
  LAB_RUN_VERSION,
  type Change,
  type Counts,
  type LabRow,
  type LabRun,
  type LabSurroundings,
  type Likeness,
  type PassTimes,
  type Spread,
} from './LabRun';

/** Maximum length of a run's JSON (characters): ten times that of the longest preset with its thumbnails. */
export const LONGEST_RUN = 32e6;

/** Limits of the lists of a run. */
const MOST = { rows: 20_000, cases: 200, series: 50, competitors: 50, passes: 100 };

const key = textLike(/^[a-z0-9][\w.@/:-]*$/i, 100, 'a key of letters, digits and hyphens');
const sentence = text(2000);
const sentences = listOf(sentence, 100);
const time = number(0, 1e9, 'ms');
const count = number(0, 1e12);
const pixels = whole(1, 16_384);

const parameter: Check<number | string | boolean> = (value, path) => {
  if (typeof value === 'boolean') return value;
  return typeof value === 'number' ? number(-1e12, 1e12)(value, path) : text(200)(value, path);
};

const labCase = fields<LabCase>({
  scene: fields({ name: key, parameters: record(parameter, 50) }),
  lights: orNull(whole(0, 1e7)),
  shadows: whole(0, 1e6),
  // this field and the next two are absent in older runs
  lightKind: orMissing(oneOf(...lightKindNames), plainCase.lightKind),
  lightRange: orMissing(orNull(number(0.1, 100, 'm')), plainCase.lightRange),
  shading: orMissing(oneOf(...shadingNames), plainCase.shading),
  overdraw: whole(0, 1e4),
  width: pixels,
  height: pixels,
});

const series = fields<LabSeries>({
  name: key,
  label: text(200),
  axis: oneOf('lights', 'objects', 'pixels', 'overdraw', 'shadows', 'kind', 'shading'),
  cases: listOf(labCase, MOST.cases),
  values: listOf(number(0, 1e12), MOST.cases),
});

const plan = fields<LabPlan>({
  preset: key,
  label: text(200),
  series: listOf(series, MOST.series),
  competitors: listOf(key, MOST.competitors, 1),
  effort: fields({
    rounds: whole(1, 1000),
    turn: time,
    changes: yesOrNo,
    longestFrame: time,
    limit: orNull(time),
  }),
});

const spread = fields<Spread>({ median: time, low: time, high: time, samples: whole(0, 1e9) });
const change = fields<Change>({ ms: time, programs: orNull(count) });

const counts = fields<Counts>({
  draws: orNull(count),
  triangles: orNull(count),
  programs: orNull(count),
  targetBytes: orNull(count),
  uploadBytes: orNull(count),
});

const passes = fields<PassTimes>({
  kind: oneOf('gpu', 'cpu'),
  passes: listOf(fields({ name: text(200), ms: time }), MOST.passes),
});

const likeness = fields<Likeness>({
  reference: key,
  psnr: orNull(number(-1000, 1000, 'dB')),
  // only pictures inside the file are allowed: fetching an address would reveal to its host who opens the file
  thumbnail: textLike(
    /^(data:image\/(webp|png|jpeg);base64,[A-Za-z0-9+/]*={0,2})?$/,
    400_000,
    'a WebP, PNG or JPEG picture as a data URL, or nothing',
  ),
});

const row = fields<LabRow>({
  competitor: key,
  series: key,
  index: whole(0, MOST.cases),
  frame: orNull(spread),
  cpu: orNull(spread),
  gpu: orNull(spread),
  firstMs: orNull(time),
  added: orNull(change),
  changed: orNull(change),
  counts: orNull(counts),
  passes: orNull(passes),
  likeness: orNull(likeness),
  dropped: whole(0, 1e7),
  technique: orNull(text(200)),
  reason: orNull(sentence),
  problem: orNull(sentence),
  warnings: sentences,
});

const surroundings = fields<LabSurroundings>({
  date: textLike(
    /^\d{4}-\d\d-\d\dT\d\d:\d\d(:\d\d(\.\d+)?)?(Z|[+-]\d\d:\d\d)$/,
    40,
    'a date as in 2026-11-22T18:00:00Z',
  ),
  device: text(500),
  browser: text(500),
  system: text(500),
  cores: orNull(whole(1, 1e5)),
  build: text(200),
  versions: record(text(100), 50),
  command: orNull(sentence),
  warnings: sentences,
});

const run = fields<LabRun>({
  format: oneOf('farol-lab-run'),
  version: oneOf(LAB_RUN_VERSION),
  id: key,
  name: orMissing(text(200), ''),
  surroundings,
  plan,
  rows: listOf(row, MOST.rows),
  complete: yesOrNo,
  duration: time,
});

/**
 * Parses the JSON of a run, which may be from an untrusted source. Unknown fields are dropped.
 *
 * @param source - the JSON, {@link LONGEST_RUN} characters at most
 * @throws FormatError that names the field, its value and a valid one
 */
export function parseRun(source: string): LabRun {
  if (source.length > LONGEST_RUN) {
    const megabytes = (source.length / 1e6).toFixed(0);
    throw new FormatError(`The file has ${megabytes} MB: a run has at most ${LONGEST_RUN / 1e6} MB.`);
  }
  let value: unknown;
  try {
    value = JSON.parse(source);
  } catch (error) {
    const why = error instanceof Error ? error.message.replaceAll(/\s+/g, ' ').slice(0, 120) : '';
    throw new FormatError(t('The file is not JSON ({why}): choose a run that the Lab exported as JSON.', { why }));
  }
  return readRun(value);
}

/**
 * Checks a run that is parsed already, such as one of the store.
 *
 * @throws FormatError naming an invalid field
 */
export function readRun(value: unknown): LabRun {
  checkFormat(value);
  const read = run(value, '');
  checkReferences(read);
  return read;
}

/** Reports a file of another kind before its fields are checked. */
function checkFormat(value: unknown): void {
  const { format, version } = (typeof value === 'object' && value !== null ? value : {}) as Partial<
    Record<'format' | 'version', unknown>
  >;
  if (format !== 'farol-lab-run') {
    throw new FormatError(
      t('This is not a run of the Lab: choose a file that the Lab exported as JSON ("format": "farol-lab-run").'),
    );
  }
  if (typeof version === 'number' && version > LAB_RUN_VERSION) {
    throw new FormatError(
      `The run has version ${version} of the format, this Lab reads ${LAB_RUN_VERSION}: open it in a newer Lab.`,
    );
  }
}

/** Checks that each row is of a case and a competitor of the plan, and that no row occurs twice. */
function checkReferences({ plan, rows }: LabRun): void {
  const lengths = new Map<string, number>();
  plan.series.forEach(({ name, cases, values }, i) => {
    if (lengths.has(name)) throw new FormatError(`plan.series[${i}].name is "${name}" once more: give each its own.`);
    if (values.length !== cases.length) {
      throw new FormatError(
        `plan.series[${i}].values has ${values.length} entries: give one for each of the ${cases.length} cases.`,
      );
    }
    lengths.set(name, cases.length);
  });
  const competitors = new Set(plan.competitors);
  const seen = new Set<string>();
  rows.forEach(({ competitor, series, index }, i) => {
    const length = lengths.get(series);
    if (length === undefined) {
      throw new FormatError(`rows[${i}].series is "${series}": give the name of a series of the plan.`);
    }
    if (index >= length) {
      throw new FormatError(`rows[${i}].index is ${index}: series "${series}" has ${length} cases.`);
    }
    if (!competitors.has(competitor)) {
      throw new FormatError(`rows[${i}].competitor is "${competitor}": give one that plan.competitors lists.`);
    }
    const place = `${competitor} ${series} ${index}`;
    if (seen.has(place)) {
      throw new FormatError(`rows[${i}] is ${competitor} in case ${index} of ${series} once more: give each row once.`);
    }
    seen.add(place);
  });
}
