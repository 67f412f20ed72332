import { shortText } from '@farol/editing';
import { describeValue } from '@farol/editing/fields';
import { FileError, type FileProblem } from '../guard/FileError';
import { fileLimits } from '../guard/fileLimits';
import { FilePath, type PathLike } from './FilePath';

export type JsonRecord = Record<string, unknown>;

export const isRecord = (value: unknown): value is JsonRecord =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** Collects the problems of a file while its values are read with a check of their types. */
export class ProblemList {
  readonly problems: FileProblem[] = [];

  private count = 0;

  /** Whether the list is full: further problems are only counted. */
  get isFull(): boolean {
    return this.problems.length >= fileLimits.problems;
  }

  add(path: PathLike, problem: string): void {
    this.count++;
    if (!this.isFull) this.problems.push({ path: String(path), problem });
  }

  /** @throws FileError when there is a problem */
  throwIfAny(): void {
    if (this.count > 0) throw new FileError(this.problems, { more: this.count - this.problems.length });
  }

  /** The value as a record; any other value gives an empty one and a problem. */
  record(value: unknown, path: PathLike): JsonRecord {
    if (isRecord(value)) return value;
    this.add(path, `must be an object, not ${describeValue(value)}.`);
    return {};
  }

  /** The value as an array; any other value gives an empty one and a problem. */
  array(value: unknown, path: PathLike): unknown[] {
    if (Array.isArray(value)) return value;
    this.add(path, `must be a list, not ${describeValue(value)}.`);
    return [];
  }

  /** The value as text; any other value, or a forbidden empty text, gives '' and a problem. */
  text(value: unknown, path: PathLike, mayBeEmpty = false): string {
    if (typeof value === 'string' && (mayBeEmpty || value !== '')) return value;
    this.add(path, `must be ${mayBeEmpty ? '' : 'non-empty '}text, not ${describeValue(value)}.`);
    return '';
  }

  /** The value as a boolean; `fallback` when absent. */
  flag(value: unknown, path: PathLike, fallback: boolean): boolean {
    if (value === undefined) return fallback;
    if (typeof value === 'boolean') return value;
    this.add(path, `must be true or false, not ${describeValue(value)}.`);
    return fallback;
  }

  /** Reports keys that are not allowed. */
  onlyKeys(record: JsonRecord, path: PathLike, keys: readonly string[]): void {
    for (const key of Object.keys(record)) {
      if (!keys.includes(key)) this.add(join(path, key), `is unknown here; known are ${keys.join(', ')}. Remove it.`);
    }
  }
}

/** Path of a member of the value at a path. */
export const join = (path: PathLike, key: string | number): FilePath => new FilePath(path, key);

/**
 * A few of many names as text, for messages.
 * @param most - greatest number of names
 */
export function sampleOf(names: Iterable<string>, most = 8): string {
  const shown: string[] = [];
  for (const name of names) {
    if (shown.length === most) return `${shown.join(', ')}, …`;
    shown.push(shortText(name));
  }
  return shown.join(', ') || 'none';
}

/** A cycle of names, first and last equal, as text for messages: 'a below b below a'. */
export function ringOf(names: readonly string[], word: string): string {
  const short = names.map((name) => shortText(name, 24));
  if (short.length > 6) short.splice(4, short.length - 5, '…');
  return short.join(` ${word} `);
}
