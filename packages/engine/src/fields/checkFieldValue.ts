import { shortText } from '@farol/renderer';
import type { Field, FieldValue } from './Field';

const isFiniteNumber = (value: unknown): value is number => typeof value === 'number' && Number.isFinite(value);

/** Writes a value for a message, short and never throwing: NaN stays NaN, text is quoted. */
export function describeValue(value: unknown, depth = 0): string {
  if (value === undefined) return 'nothing';
  if (typeof value === 'number') return String(value);
  if (Array.isArray(value)) {
    if (depth > 0) return 'a list';
    const parts = value.slice(0, 4).map((each) => describeValue(each, depth + 1));
    return `[${parts.join(', ')}${value.length > 4 ? ', …' : ''}]`;
  }
  if (typeof value === 'string') return quoted(value);
  if (typeof value === 'object' && value !== null) return 'an object';
  return typeof value === 'function' ? 'a function' : shortText(String(value));
}

/** A text of a user's in quotes, for messages. */
const quoted = (text: string): string => `"${shortText(text).replaceAll('"', '\\"')}"`;

function describeRange(field: { min?: number; max?: number; unit?: string }): string {
  const unit = field.unit ? ` ${field.unit}` : '';
  if (field.min !== undefined && field.max !== undefined) return ` from ${field.min} to ${field.max}${unit}`;
  if (field.min !== undefined) return ` of at least ${field.min}${unit}`;
  if (field.max !== undefined) return ` of at most ${field.max}${unit}`;
  return field.unit ? ` (${field.unit})` : '';
}

/** What a field allows, as the end of "must be …". */
export function describeField(field: Field): string {
  switch (field.kind) {
    case 'number':
      return `${field.integer ? 'a whole number' : 'a finite number'}${describeRange(field)}`;
    case 'angle':
      return `a finite angle${describeRange(field)}`;
    case 'boolean':
      return 'true or false';
    case 'string':
      return 'text';
    case 'choice':
      return `one of ${field.options.map((option) => JSON.stringify(option)).join(', ')}`;
    case 'vector3':
      return `[x, y, z], each a finite number${describeRange(field)}`;
    case 'euler':
      return '[x, y, z], each a finite angle in rad';
    case 'colour':
      return '[r, g, b], linear, each a finite number of at least 0';
    case 'asset':
      return `the name of a ${field.assetType}, or null`;
    case 'object':
      return 'the id of a GameObject, or null';
    case 'custom':
      return field.type.allows;
  }
}

const inRange = (value: unknown, field: { min?: number; max?: number }): boolean =>
  isFiniteNumber(value) && value >= (field.min ?? -Infinity) && value <= (field.max ?? Infinity);

const isTriple = (value: unknown, test: (coordinate: unknown) => boolean): boolean =>
  Array.isArray(value) && value.length === 3 && [0, 1, 2].every((i) => test(value[i]));

/** Whether a file can hold a value. */
export const isFieldValue = (value: unknown): value is FieldValue =>
  value === null ||
  typeof value === 'string' ||
  typeof value === 'boolean' ||
  isFiniteNumber(value) ||
  isTriple(value, isFiniteNumber);

function isAllowed(field: Field, value: unknown): boolean {
  switch (field.kind) {
    case 'number':
      return inRange(value, field) && (!field.integer || Number.isInteger(value));
    case 'angle':
      return inRange(value, field);
    case 'boolean':
      return typeof value === 'boolean';
    case 'string':
      return typeof value === 'string';
    case 'choice':
      return typeof value === 'string' && field.options.includes(value);
    case 'vector3':
      return isTriple(value, (coordinate) => inRange(coordinate, field));
    case 'euler':
      return isTriple(value, isFiniteNumber);
    case 'colour':
      return isTriple(value, (channel) => isFiniteNumber(channel) && channel >= 0);
    case 'asset':
    case 'object':
      return value === null || (typeof value === 'string' && value.length > 0);
    case 'custom':
      return isFieldValue(value) && field.type.check(value);
  }
}

/**
 * Checks kind, range, NaN and infinities.
 * @returns null when `value` is allowed, else what is wrong: "must be a finite number from 0 to 1, not NaN".
 */
export function checkFieldValue(field: Field, value: unknown): string | null {
  return isAllowed(field, value) ? null : `must be ${describeField(field)}, not ${describeValue(value)}`;
}
