import type { FieldTable, FieldValue, ValuesOf } from '@farol/engine/fields';

/** A value for every field of a table: the given one, else the default. Names that the table has not are left out. */
export function withDefaults<F extends FieldTable>(fields: F, values: Record<string, FieldValue>): ValuesOf<F> {
  return Object.fromEntries(
    Object.entries(fields).map(([name, field]) => [name, values[name] ?? field.default]),
  ) as ValuesOf<F>;
}
