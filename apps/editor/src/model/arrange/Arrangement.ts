import type { Vector3Tuple } from '@farol/engine/fields';

export type ArrangementKind = 'line' | 'ring' | 'grid' | 'scatter';

/** Colours of the copies' lights: the original's, random hues, or the hues of the rainbow in order. */
export type LightColours = 'same' | 'random' | 'rainbow';

/** Settings of an arrangement: number and places of copies, and how they vary. The originals have the first places. */
export interface Arrangement {
  readonly kind: ArrangementKind;
  /** Line, ring or surface: number of objects, originals included; 1 to 20,000. */
  readonly count: number;
  /** Line: offset from each object to the next (m). */
  readonly offset: Vector3Tuple;
  /** Ring: its radius (m), and the angle that it covers (rad). */
  readonly radius: number;
  readonly arc: number;
  /** Ring: whether each object is turned by its angle on the ring. */
  readonly turns: boolean;
  /** Grid: number of objects along x, y and z, and the distance between them (m). */
  readonly counts: Vector3Tuple;
  readonly spacing: Vector3Tuple;
  /** Surface: smallest distance between two objects (m); 0 for as dense as `count` needs. */
  readonly minimumDistance: number;
  /** Surface: whether only faces that point up are used, if there are any. */
  readonly upwards: boolean;
  /** Surface: whether objects are aligned with the normal rather than upright. */
  readonly aligns: boolean;
  /** Surface: whether objects are rotated at random about their own up axis, and share by which sizes vary (0 to 1). */
  readonly randomTurn: boolean;
  readonly sizeVariation: number;
  /** Line, ring and grid: whether objects are dropped on the surface below them. */
  readonly follows: boolean;
  /** Height above the surface, along its normal or upwards (m). */
  readonly height: number;
  /** Seed of the arrangement's random offsets. */
  readonly seed: number;
  readonly colours: LightColours;
  /** Whether all lights together are as bright as the original. */
  readonly sharesLight: boolean;
  /** Share by which intensities and ranges of lights vary (0 to 1). */
  readonly intensityVariation: number;
  readonly rangeVariation: number;
  /** Whether all objects become children of a new one. */
  readonly grouped: boolean;
}

/** Maximum number of objects that one arrangement makes. */
export const MOST_COPIES = 20_000;

/** Pose of one object of an arrangement. */
export interface ArrangedPlace {
  /** Index of the original that the object is, or is a copy of. */
  readonly source: number;
  /** World position (m). */
  readonly position: Vector3Tuple;
  /** World rotation applied after the original's, as a unit quaternion; none when absent. */
  readonly turn?: readonly [number, number, number, number];
  /** Scale relative to the original; 1 when absent. */
  readonly scale?: number;
}
