import type { FieldValue, Vector3Tuple } from '@farol/engine/fields';
import type { SampleScene } from './SampleScene';

export interface Key {
  readonly time: number;
  readonly value: FieldValue;
  readonly easing?: 'linear' | 'step' | 'bezier';
  readonly control?: readonly [number, number, number, number];
}

export interface Track {
  /** Object names from below the animated object down; '' for that object. */
  readonly path: string;
  readonly component: string;
  readonly field: string;
  readonly keys: readonly Key[];
}

/** Bézier control points: slow at both ends. */
export const EASE = [0.42, 0, 0.58, 1] as const;
/** Bézier control points of a fall: slow, then fast; RISE is the reverse. */
export const FALL = [0.5, 0, 0.9, 0.7] as const;
export const RISE = [0.1, 0.3, 0.5, 1] as const;

/** Keys with eased interpolation. */
export const eased = (...keys: readonly (readonly [time: number, value: FieldValue])[]): Key[] =>
  keys.map(([time, value]) => ({ time, value, easing: 'bezier', control: EASE }));

/** Keys whose values stay until the next one. */
export const steps = (...keys: readonly (readonly [time: number, value: FieldValue])[]): Key[] =>
  keys.map(([time, value]) => ({ time, value, easing: 'step' }));

/** Keys of a full turn about an axis. */
export const turn = (seconds: number, axis: 0 | 1 | 2 = 1): Key[] =>
  [0, 1, 2, 3, 4].map((quarter) => {
    const value: [number, number, number] = [0, 0, 0];
    value[axis] = (quarter * Math.PI) / 2;
    return { time: (quarter * seconds) / 4, value: value as Vector3Tuple };
  });

/** A track of the animated object, or of one below it. @param field - 'Component.field' */
export const track = (path: string, field: string, keys: readonly Key[]): Track => {
  const [component, name] = field.split('.');
  return { path, component, field: name, keys };
};

/** Adds a clip. @returns its name */
export function addClip(scene: SampleScene, name: string, duration: number, tracks: readonly Track[]): string {
  return scene.asset('clip', name, { data: JSON.stringify({ tracks, events: [] }), duration });
}
