import type { Field, FieldTable } from '@farol/editing/fields';

/** A field that a file holds. */
export interface SavedField {
  readonly name: string;
  readonly field: Field;
}

const known = new WeakMap<FieldTable, readonly SavedField[]>();

/** The fields of a table but for views of others: found once for each table, since scenes have many components of few types. */
export function savedFields(fields: FieldTable): readonly SavedField[] {
  let list = known.get(fields);
  if (!list) {
    list = Object.entries(fields).flatMap(([name, field]) => (field.viewOf === undefined ? [{ name, field }] : []));
    known.set(fields, list);
  }
  return list;
}
