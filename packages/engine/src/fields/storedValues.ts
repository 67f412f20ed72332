import { checkFieldValue, type Field, type FieldValue, sameValue } from '@farol/editing/fields';

/**
 * Stored values of views (see `Field.viewOf`), by the field that stores them: a string field stores its views'
 * non-default values as a JSON object; an asset field stores the value of its one view.
 */
export type StoredValues = Readonly<Record<string, FieldValue>>;

/** Name of a value within the field that stores it: 'height' of 'surface.height'. */
export const entryOf = (name: string): string => name.slice(name.indexOf('.') + 1);

const isEntry = (field: Field): boolean => field.kind !== 'asset';

/** The value of a view; its default where none, or an invalid one, is stored. */
export function storedValue(field: Field, stored: FieldValue | undefined): FieldValue {
  return stored === undefined || checkFieldValue(field, stored) !== null ? field.default : stored;
}

export function viewedValue(values: StoredValues, name: string, field: Field): FieldValue {
  const held = values[field.viewOf!];
  return isEntry(field) ? storedValue(field, readStored(String(held ?? ''))[entryOf(name)]) : (held ?? field.default);
}

/** A copy of stored values in which one view's value is changed. */
export function withViewedValue(values: StoredValues, name: string, field: Field, value: FieldValue): StoredValues {
  const place = field.viewOf!;
  const { [place]: held, ...others } = values;
  if (!isEntry(field)) return sameValue(value, field.default) ? others : { ...others, [place]: value };
  const text = withEntry(readStored(String(held ?? '')), name, field, value);
  return text === '' ? others : { ...others, [place]: text };
}

/** Text of stored values with one view's value changed; a default value is left out. */
export function withEntry(stored: StoredValues, name: string, field: Field, value: FieldValue): string {
  const { [entryOf(name)]: _before, ...others } = stored;
  return writeStored(sameValue(value, field.default) ? others : { ...others, [entryOf(name)]: value });
}

/** Parses the JSON of a string field; invalid text gives no values. */
export function readStored(text: string): StoredValues {
  if (text === '') return {};
  try {
    const values = JSON.parse(text) as unknown;
    return typeof values === 'object' && values !== null && !Array.isArray(values) ? (values as StoredValues) : {};
  } catch {
    return {};
  }
}

/** Stores values as JSON with sorted names, so that equal values give equal texts; '' for none. */
export function writeStored(values: StoredValues): string {
  const names = Object.keys(values).toSorted();
  return names.length === 0 ? '' : JSON.stringify(Object.fromEntries(names.map((name) => [name, values[name]])));
}
