import type { FieldTable } from './Field';

/**
 * Whether a field matters at present: its `visibleWhen` holds, and so do those of the fields it names.
 * @param get - reads the value of a field by its name
 */
export function isFieldVisible(fields: FieldTable, name: string, get: (field: string) => unknown): boolean {
  const seen = new Set<string>();
  const holds = (field: string): boolean => {
    if (seen.has(field)) return true;
    seen.add(field);
    for (let condition = fields[field]?.visibleWhen; condition; condition = condition.and) {
      if (!condition.equals.includes(get(condition.field)) || !holds(condition.field)) return false;
    }
    return true;
  };
  return holds(name);
}
