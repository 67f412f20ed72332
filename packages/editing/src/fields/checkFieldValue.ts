import { shortText } from '../shortText';
import type { Curve, Field, FieldValue, Gradient } from './Field';

/** Greatest number of keys in a curve or a gradient. */
export const MOST_KEYS = 64;

const isFiniteNumber = (value: unknown): value is number => typeof value === 'number' && Number.isFinite(value);

/** Formats a value for a message, in short; never throws. NaN stays NaN, text is quoted. */
export function describeValue(value: unknown, depth = 0): string {
  if (value === undefined) return 'nothing';
  if (typeof value === 'number') return String(value);
  if (Array.isArray(value)) {
    if (depth > 1) return 'a list';
    const parts = value.slice(0, 4).map((each) => describeValue(each, depth + 1));
    return `[${parts.join(', ')}${value.length > 4 ? ', …' : ''}]`;
  }
  if (typeof value === 'string') return quoted(value);
  if (typeof value === 'object' && value !== null) return 'an object';
  return typeof value === 'function' ? 'a function' : shortText(String(value));
}

/** A user's text in quotes, for messages. */
const quoted = (text: string): string => `"${shortText(text).replaceAll('"', '\\"')}"`;

function describeRange(field: { min?: number; max?: number; unit?: string }): string {
  const unit = field.unit ? ` ${field.unit}` : '';
  if (field.min !== undefined && field.max !== undefined) return ` from ${field.min} to ${field.max}${unit}`;
  if (field.min !== undefined) return ` of at least ${field.min}${unit}`;
  if (field.max !== undefined) return ` of at most ${field.max}${unit}`;
  return field.unit ? ` (${field.unit})` : '';
}

/** Allowed values of a field in words, as the end of "must be …". */
export function allowedBy(field: Field): string {
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
    case 'curve':
      return `1 to ${MOST_KEYS} keys [time, value], times ascending from 0 to 1, each value a finite number${describeRange(field)}`;
    case 'gradient':
      return (
        `1 to ${MOST_KEYS} keys [time, colour, opacity], times ascending from 0 to 1, colours linear [r, g, b] of at ` +
        'least 0, opacities from 0 to 1, null for what a key leaves out, though not in all'
      );
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

const isColour = (value: unknown): boolean => isTriple(value, (channel) => isFiniteNumber(channel) && channel >= 0);

/** Whether a value is a list of 1 to `MOST_KEYS` keys, each of `size` parts, with ascending times. */
function isKeys(value: unknown, size: number): value is readonly (readonly unknown[])[] {
  if (!Array.isArray(value) || value.length < 1 || value.length > MOST_KEYS) return false;
  let before = 0;
  for (const key of value as unknown[]) {
    if (!Array.isArray(key) || key.length !== size) return false;
    const time: unknown = key[0];
    if (!isFiniteNumber(time) || time < before || time > 1) return false;
    before = time;
  }
  return true;
}

const isCurve = (value: unknown, limits: { min?: number; max?: number }): value is Curve =>
  isKeys(value, 2) && value.every((key) => inRange(key[1], limits));

const isGradient = (value: unknown): value is Gradient =>
  isKeys(value, 3) &&
  value.every(([, colour]) => colour === null || isColour(colour)) &&
  value.every(([, , opacity]) => opacity === null || inRange(opacity, { min: 0, max: 1 })) &&
  value.some(([, colour]) => colour !== null) &&
  value.some(([, , opacity]) => opacity !== null);

/** Whether a value is of a type that fields and files can hold. */
export const isFieldValue = (value: unknown): value is FieldValue =>
  value === null ||
  typeof value === 'string' ||
  typeof value === 'boolean' ||
  isFiniteNumber(value) ||
  isTriple(value, isFiniteNumber) ||
  isCurve(value, {}) ||
  isGradient(value);

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
      return isColour(value);
    case 'curve':
      return isCurve(value, field);
    case 'gradient':
      return isGradient(value);
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
  return isAllowed(field, value) ? null : `must be ${allowedBy(field)}, not ${describeValue(value)}`;
}
