import type { FieldDescription } from './FieldTarget';

const made = new WeakMap<FieldDescription, Map<string, FieldDescription>>();

/**
 * A field with the unit that its numbers have for these owners, by its `unitBy`; the field itself where it has none, or
 * where the owners differ. The same object for the same unit.
 *
 * @param valuesOf - the values, one of each owner, of another field of theirs
 */
export function fieldInUnit<F extends FieldDescription>(field: F, valuesOf: (name: string) => readonly unknown[]): F {
  const { unitBy } = field;
  if (!unitBy) return field;
  const units = new Set(valuesOf(unitBy.field).map((value) => unitBy.units[String(value)] ?? field.unit));
  const [unit] = units;
  if (units.size !== 1 || unit === undefined || unit === field.unit) return field;
  let byUnit = made.get(field);
  if (!byUnit) made.set(field, (byUnit = new Map()));
  let known = byUnit.get(unit);
  if (!known) byUnit.set(unit, (known = { ...field, unit }));
  return known as F;
}
