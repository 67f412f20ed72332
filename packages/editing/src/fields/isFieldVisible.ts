import type { FieldTable } from './Field';

/**
 * Whether a field is visible at present: its `visibleWhen` holds, and the fields named there are visible.
 * @param get - reads the value of a field by its name
 */
export function isFieldVisible(fields: FieldTable, name: string, get: (field: string) => unknown): boolean {
  return holds(fields, name, get, null);
}

/** Whether the condition of a field holds. @param above - fields already visited, which ends cycles of conditions */
function holds(
  fields: FieldTable,
  name: string,
  get: (field: string) => unknown,
  above: readonly string[] | null,
): boolean {
  let condition = fields[name]?.visibleWhen;
  if (!condition || above?.includes(name)) return true;
  let way: readonly string[] | null = null;
  for (; condition; condition = condition.and) {
    const { field } = condition;
    if (!condition.equals.includes(get(field))) return false;
    if (fields[field]?.visibleWhen && !holds(fields, field, get, (way ??= [...(above ?? []), name]))) return false;
  }
  return true;
}
