import type { ClipData, ClipKey, ClipTrack } from '@farol/engine';
import { type Field, type FieldValue, isTriple } from '@farol/engine/fields';
import { curveAt } from './easingCurve';

/** What a track is of: see `ClipTrack`. */
export type TrackAddress = Pick<ClipTrack, 'path' | 'component' | 'field'>;

/** Keys nearer to each other (s) are at the same time. */
export const SAME_TIME = 1e-5;

export const isSameTime = (a: number, b: number): boolean => Math.abs(a - b) < SAME_TIME;

/** Names a track within its clip. */
export const trackId = ({ path, component, field }: TrackAddress): string => `${path}\n${component}\n${field}`;

/** The place of a time: the same for times that are the same. */
export const keyPlace = (time: number): number => Math.round(time / SAME_TIME);

/** Names a key within its clip, as long as it stays at its time. @param track - `trackId` of its track */
export const keyId = (track: string, time: number): string => `${track}\n${keyPlace(time)}`;

/** The track and the place that a key is named by. */
export function splitKeyId(id: string): [track: string, place: number] {
  const at = id.lastIndexOf('\n');
  return [id.slice(0, at), Number(id.slice(at + 1))];
}

/** A time with the digits that are kept in the text of a clip. */
export const roundTime = (time: number): number => Number(time.toPrecision(9));

export const EMPTY_CLIP: ClipData = { tracks: [], events: [] };

/** Kinds of fields that tracks may be of. */
const animatedKinds: ReadonlySet<Field['kind']> = new Set([
  'number',
  'angle',
  'vector3',
  'euler',
  'colour',
  'boolean',
  'choice',
] as const);

/** Whether a track may be of a field. */
export const isAnimatable = (field: Field | undefined): boolean =>
  field !== undefined && animatedKinds.has(field.kind) && !field.readOnly;

/** Whether values go from one to the next; others step. */
export const isNumeric = (value: FieldValue | undefined): boolean => typeof value === 'number' || isTriple(value);

export const findTrack = (data: ClipData, address: TrackAddress): ClipTrack | undefined => {
  const { path, component, field } = address;
  return data.tracks.find((track) => track.path === path && track.component === component && track.field === field);
};

/** The value that is a share of the way from one to the other; the first where there is no way between them. */
export function mixValues(from: FieldValue, to: FieldValue, way: number): FieldValue {
  if (typeof from === 'number' && typeof to === 'number') return from + (to - from) * way;
  if (isTriple(from) && isTriple(to)) {
    return [from[0] + (to[0] - from[0]) * way, from[1] + (to[1] - from[1]) * way, from[2] + (to[2] - from[2]) * way];
  }
  return from;
}

/** The index of the last key at or before a time; -1 when all are after it. */
export function keyBefore(keys: readonly ClipKey[], time: number): number {
  let [low, high] = [0, keys.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (keys[middle].time <= time + SAME_TIME) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/** The value of keys, at least one, at a time: the first one's before it, the last one's after it. */
export function valueAt(keys: readonly ClipKey[], time: number): FieldValue {
  const i = keyBefore(keys, time);
  if (i < 0) return keys[0].value;
  const from = keys[i];
  const to = keys[i + 1];
  if (!to || from.easing === 'step' || isSameTime(from.time, time)) return from.value;
  const share = (time - from.time) / (to.time - from.time);
  return mixValues(from.value, to.value, from.easing === 'bezier' ? curveAt(share, from.control) : share);
}

/** The time of the last key or event; 0 when there is none. */
export const lastTime = ({ tracks, events }: ClipData): number =>
  Math.max(0, ...tracks.map(({ keys }) => keys.at(-1)?.time ?? 0), ...events.map(({ time }) => time));
