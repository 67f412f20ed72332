import type { FieldValue } from '@farol/engine/fields';

/** Text form of an event's value: `true`, `0.5`, `[1, 2, 3]`, `door`; '' for none. */
export function eventValueText(value: FieldValue | undefined): string {
  if (value === undefined) return '';
  if (typeof value !== 'string') return JSON.stringify(value).replaceAll(',', ', ');
  // text that would be parsed as something else, or as nothing, is quoted
  return value === '' || typeof readEventValue(value) !== 'string' || value.startsWith('"')
    ? JSON.stringify(value)
    : value;
}

/** Parses the text form of an event's value; undefined for none. */
export function readEventValue(text: string): FieldValue | undefined {
  const typed = text.trim();
  if (typed === '') return undefined;
  try {
    const value: unknown = JSON.parse(typed);
    if (value === null || ['number', 'boolean', 'string'].includes(typeof value)) return value as FieldValue;
    if (Array.isArray(value) && value.length === 3 && value.every((each) => typeof each === 'number'))
      return value as unknown as FieldValue;
  } catch {
    // a text that is no JSON is the value itself
  }
  return typed;
}
