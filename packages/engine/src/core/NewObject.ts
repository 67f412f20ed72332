import type { FieldValue, Vector3Tuple } from '@farol/editing/fields';
import type { ComponentClass } from './ComponentClass';

/** Field values by name. */
type Values = Readonly<Record<string, FieldValue>>;

/** An object offered by an editor's Add menu; it gets the component whose class lists it in `newObjects`. */
export interface NewObject {
  /** Text of the menu entry, in English. */
  readonly label: string;
  /** Name of the object, in English; the label when absent. */
  readonly name?: string;
  /** Section of the Add menu that has the entry; 'object' when absent. */
  readonly group?: 'object' | 'building' | 'light' | 'particles';
  /** Name of the entry's icon; the component's when absent. */
  readonly icon?: string;
  /** Rotation of the object (rad, Euler angles XYZ). */
  readonly rotation?: Vector3Tuple;
  /** Initial values of the component, or a function that fetches them; defaults when absent. */
  readonly values?: Values | (() => Promise<Values>);
  /** Another component of the object, with its values. */
  readonly with?: readonly [ComponentClass, Values];
}
