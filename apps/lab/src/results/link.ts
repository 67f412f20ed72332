import { shortText } from '@farol/editing';
import { competitorNames } from '../competitors/competitorNames';
import type { Configuration, SeriesChoice } from '../plan/Configuration';
import { type Axis, isNamed } from '../plan/LabPlan';
import { type LightKind, lightKindNames, type Shading, shadingNames } from '../plan/lightKinds';
import { planOf } from '../plan/planOf';
import { presets } from '../plan/presets';

/** A configuration read from an address, and its errors, each a sentence. */
export interface Linked {
  configuration: Configuration;
  problems: string[];
}

/** Configuration to start with when the address has no preset: its series come from the address. */
const custom = (): Configuration => ({ ...presets.lights.configuration, preset: 'custom' });

const baseOf = (preset: string): Configuration =>
  Object.hasOwn(presets, preset) ? presets[preset].configuration : custom();

/**
 * Fragment of an address, with its `#`, that restores a configuration: the preset, and the settings that differ from
 * the preset's, as in `#preset=lights&size=1920x1080` or `#preset=custom&series=sponza:lights:10,100`.
 */
export function linkOf(configuration: Configuration): string {
  const base = baseOf(configuration.preset);
  const parts = [`preset=${encodeURIComponent(configuration.preset)}`];
  const add = (name: string, value: string, default_: string): void => {
    if (value !== default_) parts.push(`${name}=${value}`);
  };
  const series = configuration.series.map(seriesText);
  const isCustom = configuration.preset === 'custom';
  if (isCustom || series.join(' ') !== base.series.map(seriesText).join(' ')) {
    parts.push(...series.map((text) => `series=${text}`));
  }
  add('size', sizeText(configuration), sizeText(base));
  add('techniques', configuration.competitors.join(','), base.competitors.join(','));
  for (const [name, { write }] of Object.entries(effortFields)) {
    add(name, write(configuration.effort), write(base.effort));
  }
  return `#${parts.join('&')}`;
}

/** Names of all settings of the address. */
export const linkNames = ['preset', 'series', 'size', 'techniques', 'rounds', 'turn', 'changes', 'longest', 'seconds'];

/** A name or a value as a problem quotes it. */
const shortened = (text: string): string => shortText(text, 60);
/** Maximum number of problems listed of one kind; further ones are counted. */
const MOST_PROBLEMS = 3;

/** Maximum number of series of a plan, and of values of a series. */
const MOST_SERIES = 50;
const MOST_VALUES = 200;

/** Adds the first problems of a kind. @param others - text added when more are left out, with `#` for their number */
function addProblems(problems: string[], all: readonly string[], others: string): void {
  problems.push(...all.slice(0, MOST_PROBLEMS));
  if (all.length > MOST_PROBLEMS) problems.push(`So ${others.replace('#', String(all.length - MOST_PROBLEMS))}.`);
}

/**
 * Reads a configuration from an address's fragment. Each invalid setting is reported, and replaced by its default.
 *
 * @param fragment - with or without `#`
 * @returns null if the fragment has neither a preset nor series
 */
export function configurationOf(fragment: string): Linked | null {
  const values = new URLSearchParams(fragment.replace(/^#/, ''));
  if (!values.has('preset') && !values.has('series')) return null;
  const problems: string[] = [];
  const preset = presetOf(values, problems);
  const base = baseOf(preset);
  const asked = values.getAll('series');
  const broken: string[] = [];
  const series = asked.slice(0, MOST_SERIES).flatMap((text) => readSeries(text, base, broken));
  addProblems(problems, broken, 'are # other series');
  if (asked.length > MOST_SERIES) {
    problems.push(`The address has ${asked.length} series, and ${MOST_SERIES} is the limit: the others are left out.`);
  }
  if (preset === 'custom' && series.length === 0) {
    problems.push('The address names no series, as in series=sponza:lights:10,100: those of Lights stand in.');
  }
  const effort = { ...base.effort };
  for (const [name, field] of Object.entries(effortFields)) {
    const text = values.get(name);
    if (text !== null && !field.read(text, effort))
      problems.push(`${name}=${shortened(text)} is none: give ${field.mend}.`);
  }
  const configuration: Configuration = {
    preset,
    series: series.length > 0 ? series : base.series,
    ...readSize(values.get('size'), base, problems),
    competitors: readCompetitors(values.get('techniques'), base, problems),
    effort,
  };
  const unknown = [...new Set(values.keys())].filter((name) => !linkNames.includes(name));
  const told = unknown.map((name) => `The address has a setting ${shortened(name)}, which the Lab does not know.`);
  addProblems(problems, told, 'are # other settings');
  return { configuration, problems };
}

function presetOf(values: URLSearchParams, problems: string[]): string {
  const name = values.get('preset') ?? 'custom';
  if (name === 'custom' || Object.hasOwn(presets, name)) return name;
  problems.push(
    `There is no preset ${shortened(name)}: Quick stands in. Known are ${Object.keys(presets).join(', ')}.`,
  );
  return 'quick';
}

/** `scene:axis:values`, then `n=`, `lights=`, `kind=`, `range=` and `shading=` for values other than the defaults. */
function seriesText({ scene, axis, values, n, lights, lightKind, lightRange, shading }: SeriesChoice): string {
  const planes = scene === 'benchmarkLights' && axis !== 'objects' ? [`n=${n}`] : [];
  const lit = axis === 'lights' || scene === 'own' ? [] : [`lights=${lights}`];
  const along = isNamed(axis) ? values.map((value) => namesOf(axis)[value]) : values;
  const kind = axis !== 'kind' && (lightKind ?? 'points') !== 'points' ? [`kind=${lightKind}`] : [];
  const range = (lightRange ?? null) === null ? [] : [`range=${lightRange}`];
  const shaded = axis !== 'shading' && (shading ?? 'own') !== 'own' ? [`shading=${shading}`] : [];
  return [encodeURIComponent(scene), axis, along.join(','), ...planes, ...lit, ...kind, ...range, ...shaded].join(':');
}

const namesOf = (axis: 'kind' | 'shading'): readonly string[] => (axis === 'kind' ? lightKindNames : shadingNames);

function readSeries(text: string, base: Configuration, problems: string[]): SeriesChoice[] {
  const [scene, axis, values = '', ...settings] = text.split(':');
  const choice: Writable<SeriesChoice> = {
    scene,
    axis: axis as Axis,
    values: values.split(',').map((value) => valueOf(axis as Axis, value)),
    n: 1,
    lights: 0,
  };
  let problem: string | null = choice.values.some(Number.isNaN) ? valuesProblem(choice.axis) : null;
  if (choice.values.length > MOST_VALUES) {
    problem = `it has ${choice.values.length} values, and ${MOST_VALUES} is the limit`;
  }
  for (const setting of settings) {
    const [name, value] = setting.split('=');
    const number = numberOf(value ?? '');
    if (name === 'n' && Number.isInteger(number) && number >= 1 && number <= 100) choice.n = number;
    else if (name === 'lights' && value === 'objects') choice.lights = value;
    else if (name === 'lights' && number >= 0 && number <= 1e6) choice.lights = number;
    else if (name === 'kind') choice.lightKind = value as LightKind;
    else if (name === 'range') choice.lightRange = number;
    else if (name === 'shading') choice.shading = value as Shading;
    else problem ??= `${shortened(setting)} is unknown`;
  }
  try {
    if (problem === null) planOf({ ...base, series: [choice] });
  } catch (error) {
    problem = error instanceof Error ? error.message.replace(/\.$/, '') : String(error);
  }
  if (problem === null) return [choice];
  // the message is cut, since messages of a plan quote names in full
  const reason = shortText(problem, 400);
  problems.push(
    `series=${shortened(text)} is left out: ${reason}. A series is scene:axis:values, as in sponza:lights:10,100.`,
  );
  return [];
}

/** Parses a value along an axis: a number, or the index of a name; NaN for an unknown name. */
function valueOf(axis: Axis, text: string): number {
  if (!isNamed(axis)) return numberOf(text);
  const at = namesOf(axis).indexOf(text);
  return at < 0 ? Number.NaN : at;
}

function valuesProblem(axis: Axis): string {
  return isNamed(axis) ? `its values are not all among ${namesOf(axis).join(', ')}` : 'its values are no numbers';
}

const sizeText = ({ width, height }: { width: number; height: number }): string => `${width}x${height}`;

function readSize(text: string | null, { width, height }: Configuration, problems: string[]) {
  if (text === null) return { width, height };
  const [, ...sides] = /^(\d{1,5})[x×](\d{1,5})$/.exec(text) ?? [];
  const [w, h] = sides.map(Number);
  if (sides.length === 2 && Math.min(w, h) >= 16 && Math.max(w, h) <= 8192) return { width: w, height: h };
  problems.push(`size=${shortened(text)} is none: give width x height from 16x16 to 8192x8192, as in 1280x720.`);
  return { width, height };
}

function readCompetitors(text: string | null, base: Configuration, problems: string[]): readonly string[] {
  if (text === null) return base.competitors;
  const asked = [...new Set(text.split(','))].filter((name) => name !== '');
  const known = asked.filter((name) => Object.hasOwn(competitorNames, name));
  const unknown = asked.filter((name) => !known.includes(name));
  if (unknown.length > 0) {
    const names = Object.keys(competitorNames).join(', ');
    problems.push(`techniques=${shortened(unknown.join(','))}: there is none of that name. Known are ${names}.`);
  }
  if (known.length > 0) return known;
  if (unknown.length === 0) problems.push('techniques= names none: those of the preset stand in.');
  return base.competitors;
}

type Writable<T> = { -readonly [Key in keyof T]: T[Key] };
type Effort = Writable<Configuration['effort']>;

interface EffortField {
  write(effort: Configuration['effort']): string;
  /** Parses the text and sets the value. @returns whether the text is valid */
  read(text: string, effort: Effort): boolean;
  /** Description of a valid text. */
  mend: string;
}

function numeric(
  { min, max, isWhole = false }: { min: number; max: number; isWhole?: boolean },
  what: string,
  get: (effort: Configuration['effort']) => number,
  set: (effort: Effort, value: number) => void,
): EffortField {
  return {
    mend: `${what} from ${min} to ${max}`,
    write: (effort) => String(get(effort)),
    read(text, effort) {
      const value = numberOf(text);
      if (!(value >= min && value <= max) || (isWhole && !Number.isInteger(value))) return false;
      set(effort, value);
      return true;
    },
  };
}

/** Settings of the effort by name in the address. */
const effortFields: Readonly<Record<string, EffortField>> = {
  rounds: numeric(
    { min: 1, max: 100, isWhole: true },
    'a whole number of turns',
    ({ rounds }) => rounds,
    (effort, value) => (effort.rounds = value),
  ),
  turn: numeric(
    { min: 10, max: 60_000 },
    'milliseconds a turn',
    ({ turn }) => turn,
    (effort, value) => (effort.turn = value),
  ),
  changes: {
    mend: 'yes or no',
    write: ({ changes }) => (changes ? 'yes' : 'no'),
    read(text, effort) {
      effort.changes = text === 'yes' || (text !== 'no' && effort.changes);
      return text === 'yes' || text === 'no';
    },
  },
  longest: numeric(
    { min: 10, max: 600_000 },
    'milliseconds of the longest frame',
    ({ longestFrame }) => longestFrame,
    (effort, value) => (effort.longestFrame = value),
  ),
  seconds: numeric(
    { min: 0, max: 86_400 },
    'seconds for the whole run, 0 for no limit,',
    ({ limit }) => (limit ?? 0) / 1000,
    (effort, value) => (effort.limit = value === 0 ? null : value * 1000),
  ),
};

const numberOf = (text: string): number => (text.trim() === '' ? Number.NaN : Number(text));
