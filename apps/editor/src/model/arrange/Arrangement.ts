import type { Vector3Tuple } from '@farol/engine/fields';

export type ArrangementKind = 'line' | 'ring' | 'grid' | 'scatter';

/** How the lights of copies get their colours: as the original's, of any hue, or of all hues in turn. */
export type LightColours = 'same' | 'random' | 'rainbow';

/** How many copies there shall be, where, and how they differ. The originals are the first of them. */
export interface Arrangement {
  readonly kind: ArrangementKind;
  /** How many there are in the end, the original included: of a line, a ring, a surface; 1 to 20,000. */
  readonly count: number;
  /** Line: from each to the next (m). */
  readonly offset: Vector3Tuple;
  /** Ring: its radius (m), and how far round it goes (rad). */
  readonly radius: number;
  readonly arc: number;
  /** Ring: whether each is turned as far as it is round the ring. */
  readonly turns: boolean;
  /** Grid: how many along x, y and z, and how far apart (m). */
  readonly counts: Vector3Tuple;
  readonly spacing: Vector3Tuple;
  /** Surface: how close two may be (m); 0 for as close as it comes. */
  readonly minimumDistance: number;
  /** Surface: whether only what faces up counts, where there is such. */
  readonly upwards: boolean;
  /** Surface: whether each stands along the normal, not upright. */
  readonly aligns: boolean;
  /** Surface: whether each is turned about its own axis at random, and by what part the sizes differ (0 to 1). */
  readonly randomTurn: boolean;
  readonly sizeVariation: number;
  /** Line, ring and grid: whether each goes down to the surface below it. */
  readonly follows: boolean;
  /** How far from the surface, along its normal or upwards (m). */
  readonly height: number;
  /** Of all that is random. */
  readonly seed: number;
  readonly colours: LightColours;
  /** Whether all lights together are as bright as the original; null for: where there are many. */
  readonly sharesLight: boolean | null;
  /** By what part the intensities and ranges of lights differ (0 to 1). */
  readonly intensityVariation: number;
  readonly rangeVariation: number;
  /** Whether all are put below a new object. */
  readonly grouped: boolean;
}

/** So many lights share the brightness of the original unless it is said that they do not. */
const MANY_LIGHTS = 20;

/** Whether the lights of an arrangement share the brightness of the original. @param total - how many there are */
export const sharesLight = ({ sharesLight: shares }: Arrangement, total: number): boolean =>
  shares ?? total >= MANY_LIGHTS;

/** The most that one arrangement makes. */
export const MOST_COPIES = 20_000;

/** Where one of an arrangement is. */
export interface ArrangedPlace {
  /** Which of the originals it is, or is a copy of. */
  readonly source: number;
  /** In the world (m). */
  readonly position: Vector3Tuple;
  /** Turn in the world on top of the original's: a unit quaternion; none when absent. */
  readonly turn?: readonly [number, number, number, number];
  /** Factor of the original's size; 1 when absent. */
  readonly scale?: number;
}
