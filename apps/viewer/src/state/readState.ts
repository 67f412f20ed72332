import { shortText, t } from '@farol/editing';
import type { Field, FieldValue } from '@farol/engine/fields';
import type { KnownNames, ViewerState } from './ViewerState';

/** Greatest number of particles in an address. */
const MOST_PARTICLES = 200_000;
/** Greatest number of rectangle lights in an address. */
const MOST_RECTANGLES = 20_000;

/** Error for a wrong value of a parameter, with the allowed values. */
class BadValue extends Error {}

/**
 * Reads the state of a URL. A wrong value is replaced by the default, and reported as a problem: a line with the
 * parameter, the value and the allowed ones. Never throws.
 *
 * @param search - query of the URL, with or without its '?'
 */
export function readState(search: string, known: KnownNames): { state: ViewerState; problems: string[] } {
  const query = new URLSearchParams(search);
  const state: ViewerState = { ...known.defaults, parameters: { ...known.defaults.parameters } };
  state.effects = { ...known.defaults.effects };
  const problems: string[] = [];

  const readers: Record<string, (text: string) => void> = {
    scene: (text) => void (state.scene = oneOf(text, Object.keys(known.scenes))),
    technique: (text) => void (state.technique = oneOf(text, known.techniques)),
    view: (text) => void (state.view = oneOf(text, known.views)),
    quality: (text) => void (state.quality = oneOf(text, known.qualities)),
    aa: (text) => void (state.aa = oneOf(text, known.antialiasing)),
    decals: (text) => void (state.decals = boolean(text)),
    particles: (text) => void (state.particles = number(text, { min: 0, max: MOST_PARTICLES, integer: true })),
    rectangles: (text) => void (state.rectangles = number(text, { min: 0, max: MOST_RECTANGLES, integer: true })),
    time: (text) => void (state.time = number(text, { min: 0 })),
    width: (text) => void (state.width = number(text, { min: 1, max: 8192, integer: true })),
    height: (text) => void (state.height = number(text, { min: 1, max: 8192, integer: true })),
    dpr: (text) => void (state.dpr = number(text, { min: 0.1, max: 8 })),
    budget: (text) => void (state.budget = oneOf(text, known.budgets)),
    gui: (text) => void (state.gui = boolean(text)),
  };
  const attempt = (name: string, text: string, read: (text: string) => void) => {
    try {
      read(text);
    } catch (error) {
      if (!(error instanceof BadValue)) throw error;
      const values = { name, text: shortened(text), problem: error.message };
      problems.push(t('{name}={text} in the address: {problem} The default is used.', values));
    }
  };

  const entryOf = <T>(table: Readonly<Record<string, T>>, name: string): T | undefined =>
    Object.hasOwn(table, name) ? table[name] : undefined;
  for (const [name, field] of Object.entries(known.effects)) {
    readers[name] = (text) => void (state.effects[name] = fieldValue(field, text));
  }
  for (const [name, read] of Object.entries(readers)) {
    const text = query.get(name);
    if (text !== null) attempt(name, text, read);
  }
  // the chosen scene first: two scenes may have parameters of the same name with different ranges
  const scenes = [known.scenes[state.scene], ...Object.values(known.scenes)];
  const fieldOf = (name: string): Field | undefined =>
    entryOf(scenes.find(({ parameters }) => Object.hasOwn(parameters, name))?.parameters ?? {}, name);
  const names = [
    ...new Set([...Object.keys(readers), ...Object.values(known.scenes).flatMap((s) => Object.keys(s.parameters))]),
  ];
  const unknown: string[] = [];
  /** Number of occurrences of each name. */
  const times = new Map<string, number>();
  for (const [name, text] of query) {
    const before = times.get(name) ?? 0;
    times.set(name, before + 1);
    if (before > 0 || Object.hasOwn(readers, name)) continue;
    const field = fieldOf(name);
    if (field) attempt(name, text, () => void (state.parameters[name] = fieldValue(field, text)));
    else unknown.push(name);
  }
  const isUnknown = new Set(unknown);
  for (const [name, count] of times) {
    if (count > 1 && !isUnknown.has(name))
      problems.push(t('{name} is in the address {count} times: the first counts.', { name, count }));
  }
  for (const name of unknown.slice(0, MOST_UNKNOWN)) {
    problems.push(
      t('{name} in the address is unknown and left out.', {
        name: shortened(name) || t('A name of no letters'),
      }),
    );
  }
  if (unknown.length > MOST_UNKNOWN)
    problems.push(t('So are {count} others.', { count: unknown.length - MOST_UNKNOWN }));
  if (unknown.length > 0) problems.push(t('Known are {names}.', { names: names.join(', ') }));
  return { state, problems };
}

/** Unknown names that are reported one by one; further ones are only counted. */
const MOST_UNKNOWN = 3;

/** A name or a value as a problem quotes it. */
const shortened = (text: string): string => shortText(text, 60);

function oneOf(text: string, allowed: readonly string[]): string {
  if (!allowed.includes(text))
    throw new BadValue(t('it is unknown. Choose one of {names}.', { names: allowed.join(', ') }));
  return text;
}

function number(text: string, { min = -Infinity, max = Infinity, integer = false }): number {
  const value = text.trim() === '' ? NaN : Number(text);
  if (Number.isFinite(value) && value >= min && value <= max && (!integer || Number.isInteger(value))) return value;
  const range =
    max < Infinity ? t(' from {min} to {max}', { min, max }) : min > -Infinity ? t(' of {min} or more', { min }) : '';
  throw new BadValue(t(integer ? 'a whole number{range} is needed.' : 'a number{range} is needed.', { range }));
}

function boolean(text: string): boolean {
  if (text === '1' || text === 'true') return true;
  if (text === '0' || text === 'false') return false;
  throw new BadValue(t('1 or 0 is needed.'));
}

function fieldValue(field: Field, text: string): FieldValue {
  switch (field.kind) {
    case 'number':
    case 'angle':
      return number(text, field);
    case 'boolean':
      return boolean(text);
    case 'choice':
      return oneOf(text, field.options);
    case 'string':
    case 'asset':
    case 'object':
      return text;
    case 'vector3':
    case 'euler':
    case 'colour': {
      const values = text.split(',').map((part) => number(part, field.kind === 'vector3' ? field : {}));
      if (values.length !== 3) throw new BadValue(t('three numbers with commas between them are needed.'));
      return [values[0], values[1], values[2]];
    }
    case 'curve':
    case 'gradient':
    case 'custom':
      throw new BadValue(t('it does not fit into an address.'));
  }
}
