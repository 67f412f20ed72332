import { shortText } from '@farol/editing';

/** Checks a value of unknown origin. @returns a copy of its known parts @throws FormatError */
export type Check<T> = (value: unknown, path: string) => T;

/** An error in a file; the message is a sentence that names the field and the remedy. */
export class FormatError extends Error {
  override name = 'FormatError';
}

/** Throws for an invalid value. @param mend - description of a valid value, which follows "give" */
function refuse(path: string, value: unknown, mend: string): never {
  if (value === undefined) throw new FormatError(`${path} is missing: give ${mend}.`);
  throw new FormatError(`${path} is ${quoted(value)}: give ${mend}.`);
}

/** A value as quoted in a message: short, on one line. */
function quoted(value: unknown): string {
  if (Array.isArray(value)) return `a list of ${value.length}`;
  if (typeof value === 'object' && value !== null) return 'an object';
  return shortText(typeof value === 'string' ? JSON.stringify(value) : String(value));
}

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

export function text(most = 1000): Check<string> {
  return (value, path) =>
    typeof value === 'string' && value.length <= most
      ? value
      : refuse(path, value, `a text of at most ${most} characters`);
}

/** Checks a text. @param what - description of a valid text */
export function textLike(pattern: RegExp, most: number, what: string): Check<string> {
  return (value, path) =>
    typeof value === 'string' && value.length <= most && pattern.test(value) ? value : refuse(path, value, what);
}

export function number(min: number, max: number, unit = ''): Check<number> {
  return (value, path) =>
    typeof value === 'number' && value >= min && value <= max
      ? value
      : refuse(path, value, `a number from ${min} to ${max}${unit && ` (${unit})`}`);
}

export function whole(min: number, max: number): Check<number> {
  return (value, path) =>
    typeof value === 'number' && Number.isInteger(value) && value >= min && value <= max
      ? value
      : refuse(path, value, `a whole number from ${min} to ${max}`);
}

export const yesOrNo: Check<boolean> = (value, path) =>
  typeof value === 'boolean' ? value : refuse(path, value, 'true or false');

export function oneOf<const T extends string | number>(...allowed: readonly T[]): Check<T> {
  return (value, path) =>
    allowed.find((each) => each === value) ??
    refuse(path, value, allowed.map((each) => JSON.stringify(each)).join(' or '));
}

export function orNull<T>(check: Check<T>): Check<T | null> {
  return (value, path) => (value === null ? null : check(value, path));
}

/** Checks an optional field. @param fallback - value for files without the field */
export function orMissing<T>(check: Check<T>, fallback: T): Check<T> {
  return (value, path) => (value === undefined ? fallback : check(value, path));
}

export function listOf<T>(check: Check<T>, most: number, fewest = 0): Check<T[]> {
  return (value, path) => {
    if (!Array.isArray(value)) return refuse(path, value, 'a list');
    if (value.length > most) throw new FormatError(`${path} has ${value.length} entries: give at most ${most}.`);
    if (value.length < fewest) throw new FormatError(`${path} has ${value.length} entries: give at least ${fewest}.`);
    return value.map((each, i) => check(each, `${path}[${i}]`));
  };
}

/** Checks an object with arbitrary property names, at most `most`; `check` checks each value. */
export function record<T>(check: Check<T>, most: number): Check<Record<string, T>> {
  return (value, path) => {
    if (!isObject(value)) return refuse(path, value, 'an object');
    const names = Object.keys(value);
    if (names.length > most) throw new FormatError(`${path} has ${names.length} entries: give at most ${most}.`);
    for (const name of names) {
      const allowed = /^[@\w][\w@./-]{0,99}$/.test(name) && !(name in Object.prototype);
      if (!allowed)
        throw new FormatError(`${path} has an entry ${quoted(name)}: give it a name of letters and digits.`);
    }
    return Object.fromEntries(names.map((name) => [name, check(value[name], `${path}.${name}`)]));
  };
}

/** Checks an object with these fields; other fields are dropped. */
export function fields<T extends object>(checks: { readonly [Key in keyof T]-?: Check<T[Key]> }): Check<T> {
  const entries = Object.entries(checks) as [string, Check<unknown>][];
  return (value, path) => {
    if (!isObject(value)) return refuse(path || 'the file', value, 'an object');
    return Object.fromEntries(
      entries.map(([name, check]) => [name, check(value[name], path === '' ? name : `${path}.${name}`)]),
    ) as T;
  };
}
