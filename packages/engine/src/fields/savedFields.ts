import type { Field, FieldTable } from '@farol/editing/fields';

/** A field that a file holds. */
export interface SavedField {
  readonly name: string;
  readonly field: Field;
}

const known = new WeakMap<FieldTable, readonly SavedField[]>();

/** Fields of a table, without views (fields that show a part of another field); cached for each table. */
export function savedFields(fields: FieldTable): readonly SavedField[] {
  let list = known.get(fields);
  if (!list) {
    list = Object.entries(fields).flatMap(([name, field]) => (field.viewOf === undefined ? [{ name, field }] : []));
    known.set(fields, list);
  }
  return list;
}
