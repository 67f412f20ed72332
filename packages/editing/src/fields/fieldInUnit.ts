import type { FieldDescription } from './FieldTarget';

const made = new WeakMap<FieldDescription, Map<string, FieldDescription>>();

/**
 * A copy of a field with the unit that `unitBy` gives for the owners' values, cached per unit; the field itself without
 * `unitBy`, or when the owners' units differ.
 *
 * @param valuesOf - returns the values of another field, one per owner
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
