import type { FieldValue } from './Field';

/** Declaration of a field for editors; the fields of @farol/engine have this form. */
export interface FieldDescription {
  /** 'number', 'angle' (radians), 'vector3', 'euler' (radians), 'colour' (linear), 'boolean', … */
  readonly kind: string;
  /** Help text of one line. */
  readonly help: string;
  /** Label shown in place of the field's name. */
  readonly label?: string;
  /** SI unit of a number or of each coordinate, such as 'm'. */
  readonly unit?: string;
  /** Units by the value of another field of the same owner; `unit` then lists all of them. */
  readonly unitBy?: { readonly field: string; readonly units: Readonly<Record<string, string>> };
  /** Smallest value allowed of a number, an angle (radians) or each coordinate. */
  readonly min?: number;
  /** Largest value allowed. */
  readonly max?: number;
  /** Amount by which an arrow key changes the value. */
  readonly step?: number;
  /** Factor from the stored to the displayed number, for a field in a unit of the user's choice; 1 when absent. */
  readonly scale?: number;
  /** Whether only whole numbers are allowed. */
  readonly integer?: boolean;
}

/** An owner of editable fields: a component, the settings of a scene, a three object. */
export interface FieldTarget {
  /** Name of the owner in labels of the history, such as 'Light'. */
  readonly ownerName: string;
  readonly fields: Readonly<Record<string, { readonly label?: string; readonly viewOf?: string }>>;
  /** The authored value of a field, untouched by simulation. */
  getAuthored(name: string): FieldValue;
  /** @throws Error when the value is refused; nothing has changed then */
  set(name: string, value: FieldValue): void;
  /**
   * Checks a value that a user enters, for targets whose `set` accepts anything, so that undo can restore any earlier
   * value.
   * @throws Error when the value is not allowed
   */
  check?(name: string, value: FieldValue): void;
}
