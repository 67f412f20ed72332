const known = new WeakMap<FieldTable, readonly string[]>();

import type { FieldTable } from '@farol/editing/fields';

/** Names of the fields of a table that refer to objects; cached. */
export function objectFields(fields: FieldTable): readonly string[] {
  let list = known.get(fields);
  if (!list) {
    list = Object.keys(fields).filter((name) => fields[name].kind === 'object');
    known.set(fields, list);
  }
  return list;
}
