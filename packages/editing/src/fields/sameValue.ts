import type { FieldValue, Vector3Tuple } from './Field';

/** Whether a value is a vector, Euler angles or a colour: neither one number nor keys. */
export const isTriple = (value: FieldValue | undefined): value is Vector3Tuple =>
  Array.isArray(value) && value.length === 3 && typeof value[0] === 'number' && typeof value[1] === 'number';

/** Whether two field values are equal. */
export function sameValue(a: FieldValue, b: FieldValue): boolean {
  if (a === b || !Array.isArray(a) || !Array.isArray(b)) return a === b;
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; i++) if (!sameValue(a[i] as FieldValue, b[i] as FieldValue)) return false;
  return true;
}
