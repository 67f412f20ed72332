import type { FieldValue } from '@farol/editing/fields';

/** Interpolation of an animated value from a key to the next. */
export type Easing = 'linear' | 'step' | 'bezier';

/** Key of an animation track. */
export interface ClipKey {
  /** Time from the beginning of the clip (s), 0 or more. */
  readonly time: number;
  readonly value: FieldValue;
  /** Interpolation to the next key; 'linear' when absent. Flags, choices and texts always change at the next key. */
  readonly easing?: Easing;
  /**
   * With 'bezier': the two inner control points of the curve to the next key, as fractions of the interval in time (0
   * to 1) and in value, as in CSS's `cubic-bezier`; [1/3, 1/3, 2/3, 2/3], a straight line, when absent.
   */
  readonly control?: readonly [x1: number, y1: number, x2: number, y2: number];
}

/** Animation track: keys for one field of one component. */
export interface ClipTrack {
  /** Path of names from the animated object to a descendant, 'Arm/Hand'; '' for the animated object itself. */
  readonly path: string;
  /** Type name of the component: the first of the type on the object. */
  readonly component: string;
  readonly field: string;
  /** Keys in ascending order of time, each time once. */
  readonly keys: readonly ClipKey[];
}

/** A method that is called when a clip passes a time. */
export interface ClipEvent {
  /** Time from the beginning of the clip (s). */
  readonly time: number;
  /** Method called on components of the animated object and of its descendants: see `GameObject.callMethod`. */
  readonly method: string;
  /** Argument of the method; when absent, the method is called without argument. */
  readonly value?: FieldValue;
}

/** Content of a ClipAsset, stored as JSON. */
export interface ClipData {
  readonly tracks: readonly ClipTrack[];
  readonly events: readonly ClipEvent[];
}
