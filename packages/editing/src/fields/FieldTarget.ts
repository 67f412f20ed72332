/** A value that a field can have: what a scene file can hold. A triple is a vector, Euler angles or a linear colour. */
export type FieldValue = number | boolean | string | null | Triple;

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
  readonly fields: Readonly<Record<string, { readonly label?: string }>>;
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

/** Whether two field values are the same value. */
export function sameValue(a: FieldValue, b: FieldValue): boolean {
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null) return a === b;
  return a[0] === b[0] && a[1] === b[1] && a[2] === b[2];
}
