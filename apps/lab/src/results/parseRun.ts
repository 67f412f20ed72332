import { t } from '@farol/editing';
import { FormatError } from './checks';
import { checkRun, LAB_RUN_VERSION, type LabRun } from './LabRun';

/** Maximum length of a run's JSON (characters): ten times that of the longest preset with its thumbnails. */
export const LONGEST_RUN = 32e6;

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
  const read = checkRun(value, '');
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
