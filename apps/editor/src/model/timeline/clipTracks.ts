import type { ClipData, ClipKey, ClipTrack } from '@farol/engine';
import { type Field, type FieldValue, isTriple } from '@farol/engine/fields';
import { curveAt } from './easingCurve';

export { EMPTY_CLIP, trackId } from './clipDataOf';

/** Path, component and field that a track animates, see `ClipTrack`. */
export type TrackAddress = Pick<ClipTrack, 'path' | 'component' | 'field'>;

/** Keys closer than this (s) count as simultaneous. */
export const SAME_TIME = 1e-5;

export const isSameTime = (a: number, b: number): boolean => Math.abs(a - b) < SAME_TIME;

/** Time in units of `SAME_TIME`, equal for simultaneous keys. */
export const keyPlace = (time: number): number => Math.round(time / SAME_TIME);

/** Id of a key within its clip, valid until its time changes. @param track - `trackId` of its track */
export const keyId = (track: string, time: number): string => `${track}\n${keyPlace(time)}`;

/** Splits a key's id into track and time, the latter as `keyPlace`. */
export function splitKeyId(id: string): [track: string, place: number] {
  const at = id.lastIndexOf('\n');
  return [id.slice(0, at), Number(id.slice(at + 1))];
}

/** Rounds a time (s) to the digits stored in a clip. */
export const roundTime = (time: number): number => Number(time.toPrecision(9));

/** Kinds of fields that can be animated. */
const animatedKinds: ReadonlySet<Field['kind']> = new Set([
  'number',
  'angle',
  'vector3',
  'euler',
  'colour',
  'boolean',
  'choice',
] as const);

/** Whether a field can be animated. */
export const isAnimatable = (field: Field | undefined): boolean =>
  field !== undefined && animatedKinds.has(field.kind) && !field.readOnly;

/** Whether a value can be interpolated; other values change in steps. */
export const isNumeric = (value: FieldValue | undefined): boolean => typeof value === 'number' || isTriple(value);

export const findTrack = (data: ClipData, address: TrackAddress): ClipTrack | undefined => {
  const { path, component, field } = address;
  return data.tracks.find((track) => track.path === path && track.component === component && track.field === field);
};

/** Interpolates linearly; returns `from` when values cannot be interpolated. @param way - 0 to 1 */
export function mixValues(from: FieldValue, to: FieldValue, way: number): FieldValue {
  if (typeof from === 'number' && typeof to === 'number') return from + (to - from) * way;
  if (isTriple(from) && isTriple(to)) {
    return [from[0] + (to[0] - from[0]) * way, from[1] + (to[1] - from[1]) * way, from[2] + (to[2] - from[2]) * way];
  }
  return from;
}

/** Index of the last key at or before a time; -1 when all are later. */
export function keyBefore(keys: readonly ClipKey[], time: number): number {
  let [low, high] = [0, keys.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (keys[middle].time <= time + SAME_TIME) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/** Interpolated value at a time, clamped to the first and the last key. @param keys - at least one */
export function valueAt(keys: readonly ClipKey[], time: number): FieldValue {
  const i = keyBefore(keys, time);
  if (i < 0) return keys[0].value;
  const from = keys[i];
  const to = keys[i + 1];
  if (!to || from.easing === 'step' || isSameTime(from.time, time)) return from.value;
  const share = (time - from.time) / (to.time - from.time);
  return mixValues(from.value, to.value, from.easing === 'bezier' ? curveAt(share, from.control) : share);
}

/** Time of the last key or event (s); 0 when there is none. */
export const lastTime = ({ tracks, events }: ClipData): number =>
  Math.max(0, ...tracks.map(({ keys }) => keys.at(-1)?.time ?? 0), ...events.map(({ time }) => time));
