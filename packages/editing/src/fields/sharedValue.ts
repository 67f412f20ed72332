import type { FieldValue, Vector3Tuple } from './Field';
import { isTriple, sameValue } from './sameValue';

/** Value of one field over several owners. */
export interface SharedValue {
  /** The common value; null when the values differ. */
  readonly value: FieldValue;
  /** Whether the owners have different values. */
  readonly mixed: boolean;
  /** For vectors that differ: the coordinates that all owners share, null for the others; absent for other values. */
  readonly parts?: readonly (number | null)[];
}

/**
 * Compares one field's values over several owners.
 * @param values - one for each owner; at least one
 */
export function sharedValue(values: readonly FieldValue[]): SharedValue {
  const [first] = values;
  if (values.every((value) => sameValue(value, first))) return { value: first, mixed: false };
  const triples = values.filter(isTriple);
  if (triples.length < values.length) return { value: null, mixed: true };
  const parts = triples[0].map((part, i) => (triples.every((triple) => triple[i] === part) ? part : null));
  return { value: null, mixed: true, parts };
}

/**
 * Update for `FieldGesture` that sets one coordinate of a triple; each owner keeps the others.
 * @param axis - 0 to 2
 * @param value - new coordinate, or a function of the owner's present one
 */
export const withCoordinate =
  (axis: number, value: number | ((before: number) => number)) =>
  (before: Vector3Tuple): Vector3Tuple =>
    before.map((each, i) => {
      if (i !== axis) return each;
      return typeof value === 'function' ? value(each) : value;
    }) as unknown as Vector3Tuple;
