import type { FieldTable } from './Field';

/**
 * Whether a field matters at present: its `visibleWhen` holds, and so does that of the field it names.
 * @param get - reads the value of a field by its name
 */
export function isFieldVisible(fields: FieldTable, name: string, get: (field: string) => unknown): boolean {
  const seen = new Set<string>();
  for (let condition = fields[name]?.visibleWhen; condition; condition = fields[condition.field]?.visibleWhen) {
    if (seen.has(condition.field)) return true;
    seen.add(condition.field);
    if (!condition.equals.includes(get(condition.field))) return false;
  }
  return true;
}
