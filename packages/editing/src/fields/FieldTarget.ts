/**
 * A value that a field can have: what a scene file can hold. A triple is a vector, Euler angles or a linear colour; keys are
 * a curve or a gradient.
 */
export type FieldValue = number | boolean | string | null | Triple | Keys;

/** Keys by time, never changed in place: [time, value] of a curve, [time, colour, opacity] of a gradient. */
export type Keys =
  | readonly (readonly [time: number, value: number])[]
  | readonly (readonly [time: number, colour: Triple | null, opacity: number | null])[];

/** Three numbers, never changed in place: [x, y, z] or [r, g, b]. */
export type Triple = readonly [number, number, number];

/** What an editor reads of a field's declaration; the fields of @farol/engine have this shape. */
export interface FieldDescription {
  /** 'number', 'angle' (radians), 'vector3', 'euler' (radians), 'colour' (linear), 'boolean', … */
  readonly kind: string;
  /** One line of help. */
  readonly help: string;
  /** Shown in place of the field's name. */
  readonly label?: string;
  /** SI unit of a number or of each coordinate, such as 'm'. */
  readonly unit?: string;
  /** The unit by the value of another field of the same owner; `unit` names all of them then. */
  readonly unitBy?: { readonly field: string; readonly units: Readonly<Record<string, string>> };
  /** Smallest value allowed of a number, an angle (radians) or each coordinate. */
  readonly min?: number;
  /** Largest value allowed. */
  readonly max?: number;
  /** What an arrow key adds. */
  readonly step?: number;
  /** Whether only whole numbers are allowed. */
  readonly integer?: boolean;
}

/** Something whose fields are edited: a component, the settings of a scene, an object of three's. */
export interface FieldTarget {
  /** Its name in the labels of the history, such as 'Light'. */
  readonly ownerName: string;
  readonly fields: Readonly<Record<string, { readonly label?: string; readonly viewOf?: string }>>;
  /** The value that was last set, untouched by simulation. */
  getAuthored(name: string): FieldValue;
  /** @throws Error when the value is refused; nothing has changed then */
  set(name: string, value: FieldValue): void;
  /**
   * For targets whose `set` refuses nothing, so that an undo can put back whatever was there: called with each value
   * that a user enters.
   * @throws Error when the value is not allowed
   */
  check?(name: string, value: FieldValue): void;
}

/** Whether a value is three numbers. */
export const isTriple = (value: FieldValue): value is Triple =>
  Array.isArray(value) && value.length === 3 && typeof value[0] === 'number' && typeof value[1] === 'number';

/** Whether two field values are the same value. */
export function sameValue(a: FieldValue, b: FieldValue): boolean {
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null) return a === b;
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; i++) if (!sameValue(a[i] as FieldValue, b[i] as FieldValue)) return false;
  return true;
}
