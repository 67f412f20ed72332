import { describeValue } from '../fields/checkFieldValue';
import type { FileProblem } from './FileError';

export type JsonRecord = Record<string, unknown>;

export const isRecord = (value: unknown): value is JsonRecord =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** Collects what is wrong with a file, and reads parts of it that must have a type. */
export class ProblemList {
  readonly problems: FileProblem[] = [];

  add(path: string, problem: string): void {
    this.problems.push({ path, problem });
  }

  /** The value as a record; an empty one, and a problem, when it is none. */
  record(value: unknown, path: string): JsonRecord {
    if (isRecord(value)) return value;
    this.add(path, `must be an object, not ${describeValue(value)}.`);
    return {};
  }

  /** The value as an array; an empty one, and a problem, when it is none. */
  array(value: unknown, path: string): unknown[] {
    if (Array.isArray(value)) return value;
    this.add(path, `must be a list, not ${describeValue(value)}.`);
    return [];
  }

  /** The value as text; '' and a problem when it is none, or when it is empty and must not be. */
  text(value: unknown, path: string, mayBeEmpty = false): string {
    if (typeof value === 'string' && (mayBeEmpty || value !== '')) return value;
    this.add(path, `must be ${mayBeEmpty ? '' : 'non-empty '}text, not ${describeValue(value)}.`);
    return '';
  }

  /** The value as true or false; `fallback` when it is absent. */
  flag(value: unknown, path: string, fallback: boolean): boolean {
    if (value === undefined) return fallback;
    if (typeof value === 'boolean') return value;
    this.add(path, `must be true or false, not ${describeValue(value)}.`);
    return fallback;
  }

  /** Names keys that do not belong. */
  onlyKeys(record: JsonRecord, path: string, keys: readonly string[]): void {
    for (const key of Object.keys(record)) {
      if (!keys.includes(key)) this.add(join(path, key), `is unknown here; known are ${keys.join(', ')}. Remove it.`);
    }
  }
}

/** Path of a member. */
export const join = (path: string, key: string | number): string =>
  typeof key === 'number' ? `${path}[${key}]` : path ? `${path}.${key}` : key;
