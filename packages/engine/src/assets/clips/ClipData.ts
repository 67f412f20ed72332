/** How a value goes from a key to the next one. */
import type { FieldValue } from '@farol/editing/fields';
export type Easing = 'linear' | 'step' | 'bezier';

/** A value at a time. */
export interface ClipKey {
  /** Seconds from the beginning of the clip, 0 or more. */
  readonly time: number;
  readonly value: FieldValue;
  /** On the way to the next key; 'linear' when absent. Flags, choices and texts always step. */
  readonly easing?: Easing;
  /**
   * With 'bezier': the two inner control points of the curve to the next key, as shares of the way in time (0 to 1) and
   * in value, as of CSS's `cubic-bezier`; [1/3, 1/3, 2/3, 2/3], a straight line, when absent.
   */
  readonly control?: readonly [x1: number, y1: number, x2: number, y2: number];
}

/** How one field of one component goes with time. */
export interface ClipTrack {
  /** Names from below the animated object down, 'Arm/Hand'; '' for that object itself. */
  readonly path: string;
  /** Type name of the component: the first of the type on the object. */
  readonly component: string;
  readonly field: string;
  /** In order of time, each time once. */
  readonly keys: readonly ClipKey[];
}

/** A method that is called when a clip passes a time. */
export interface ClipEvent {
  /** Seconds from the beginning. */
  readonly time: number;
  /** Method called on components of the animated object and of its descendants: see `GameObject.callMethod`. */
  readonly method: string;
  /** Handed to the method, when there is one. */
  readonly value?: FieldValue;
}

/** Content of a ClipAsset, stored as JSON. */
export interface ClipData {
  readonly tracks: readonly ClipTrack[];
  readonly events: readonly ClipEvent[];
}
