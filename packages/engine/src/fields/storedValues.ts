import { checkFieldValue, type Field, type FieldValue, sameValue } from '@farol/editing/fields';

/**
 * Values of views, see `Field.viewOf`, in the field that holds them: a string field holds those of its views that are
 * not the default, as JSON by entry; an asset field is what its view shows.
 */
export type StoredValues = Readonly<Record<string, FieldValue>>;

/** Name of a value within the field that stores it: 'height' of 'surface.height'. */
export const entryOf = (name: string): string => name.slice(name.indexOf('.') + 1);

const isEntry = (field: Field): boolean => field.kind !== 'asset';

/** The value of a view; its default where none is stored, or one that it does not allow. */
export function storedValue(field: Field, stored: FieldValue | undefined): FieldValue {
  return stored === undefined || checkFieldValue(field, stored) !== null ? field.default : stored;
}

export function viewedValue(values: StoredValues, name: string, field: Field): FieldValue {
  const held = values[field.viewOf!];
  return isEntry(field) ? storedValue(field, readStored(String(held ?? ''))[entryOf(name)]) : (held ?? field.default);
}

/** Values of a file with another value of a view. */
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
