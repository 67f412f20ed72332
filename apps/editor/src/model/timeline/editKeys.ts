/**
 * Edits of the keys of a clip. Each returns a new clip and leaves the given one unchanged; untouched keys, and tracks
 * without touched keys, stay the same objects.
 */
import type { ClipData, ClipKey, ClipTrack, Easing } from '@farol/engine';
import type { FieldValue } from '@farol/engine/fields';
import {
  findTrack,
  isNumeric,
  isSameTime,
  keyBefore,
  keyId,
  keyPlace,
  roundTime,
  splitKeyId,
  type TrackAddress,
  trackId,
  valueAt,
} from './clipTracks';
import { type CurveControl, splitCurve } from './easingCurve';

/** A selection of keys, by `keyId`. */
export type KeySelection = ReadonlySet<string>;

/** A clip after an edit, and the new ids of its selected keys. */
export interface KeyEdit {
  readonly data: ClipData;
  readonly selected: KeySelection;
}

const inOrder = (a: { readonly time: number }, b: { readonly time: number }): number => a.time - b.time;

const withTracks = (data: ClipData, tracks: readonly ClipTrack[]): ClipData => ({ ...data, tracks });

const addressOf = ({ path, component, field }: TrackAddress): TrackAddress => ({ path, component, field });

/** Creates a key, leaving out properties with default values. */
function makeKey(time: number, value: FieldValue, easing: Easing | undefined, control?: CurveControl): ClipKey {
  const key: ClipKey = { time, value };
  if (easing === undefined || easing === 'linear' || !isNumeric(value)) return key;
  return easing === 'bezier' && control ? { ...key, easing, control } : { ...key, easing };
}

/** Times of the selected keys, as `keyPlace`, by track; parsed once for each selection. */
const placesByTrack = new WeakMap<KeySelection, ReadonlyMap<string, ReadonlySet<number>>>();

function placesOf(selected: KeySelection): ReadonlyMap<string, ReadonlySet<number>> {
  const known = placesByTrack.get(selected);
  if (known) return known;
  const places = new Map<string, Set<number>>();
  for (const id of selected) {
    const [track, place] = splitKeyId(id);
    const ofTrack = places.get(track);
    if (ofTrack) ofTrack.add(place);
    else places.set(track, new Set([place]));
  }
  placesByTrack.set(selected, places);
  return places;
}

const none = (): boolean => false;

/** Returns a predicate: whether a key of the track is selected. */
export function selectedIn(selected: KeySelection, track: TrackAddress): (key: ClipKey) => boolean {
  const places = selected.size === 0 ? undefined : placesOf(selected).get(trackId(track));
  return places ? ({ time }) => places.has(keyPlace(time)) : none;
}

/** Calls `visit` with each selected key. */
export function eachSelected(
  { tracks }: ClipData,
  selected: KeySelection,
  visit: (key: ClipKey, track: ClipTrack, index: number) => void,
): void {
  if (selected.size === 0) return;
  for (const track of tracks) {
    const isSelected = selectedIn(selected, track);
    if (isSelected === none) continue;
    track.keys.forEach((key, i) => {
      if (isSelected(key)) visit(key, track, i);
    });
  }
}

export function selectedKeys(
  data: ClipData,
  selected: KeySelection,
): { key: ClipKey; track: ClipTrack; index: number }[] {
  const found: { key: ClipKey; track: ClipTrack; index: number }[] = [];
  eachSelected(data, selected, (key, track, index) => found.push({ key, track, index }));
  return found;
}

/** Ids of all keys of a clip. */
export const allKeys = ({ tracks }: ClipData): Set<string> =>
  new Set(
    tracks.flatMap((track) => {
      const id = trackId(track);
      return track.keys.map(({ time }) => keyId(id, time));
    }),
  );

/** The part of a selection whose keys still exist. */
export const keptSelection = (data: ClipData, selected: KeySelection): KeySelection =>
  new Set(selectedKeys(data, selected).map(({ key, track }) => keyId(trackId(track), key.time)));

/** Inserts keys into a list, replacing simultaneous ones. @param added - in any order; later entries replace earlier */
export function insertKeys(keys: readonly ClipKey[], added: readonly ClipKey[]): ClipKey[] {
  const byPlace = new Map(added.map((key) => [keyPlace(key.time), key]));
  return [...keys.filter(({ time }) => !byPlace.has(keyPlace(time))), ...byPlace.values()].toSorted(inOrder);
}

/** Inserts a key. A key with the curve's own value splits the curve without changing its shape. */
function insertKey(keys: readonly ClipKey[], time: number, value: FieldValue | undefined): ClipKey[] {
  const i = keyBefore(keys, time);
  const before = keys[i];
  if (before && isSameTime(before.time, time)) {
    return value === undefined ? [...keys] : keys.with(i, { ...before, value });
  }
  const keyValue = value ?? valueAt(keys, time);
  const after = keys[i + 1];
  if (!before || !after || before.easing !== 'bezier') {
    return keys.toSpliced(i + 1, 0, makeKey(time, keyValue, before?.easing));
  }
  const split = splitCurve((time - before.time) / (after.time - before.time), before.control);
  return keys.toSpliced(
    i,
    1,
    makeKey(before.time, before.value, 'bezier', split.before),
    makeKey(time, keyValue, 'bezier', split.after),
  );
}

/**
 * Sets the value of a track at a time, adding key and track when missing.
 * @param value - when absent, the curve's own value, which keeps the shape; required for a new track
 */
export function setKey(data: ClipData, address: TrackAddress, at: number, value?: FieldValue): ClipData {
  const time = roundTime(at);
  const track = findTrack(data, address);
  if (!track || track.keys.length === 0) {
    if (value === undefined) return data;
    const made = { ...addressOf(address), keys: [{ time, value }] };
    return withTracks(data, track ? data.tracks.map((each) => (each === track ? made : each)) : [...data.tracks, made]);
  }
  const changed = { ...track, keys: insertKey(track.keys, time, value) };
  return withTracks(
    data,
    data.tracks.map((each) => (each === track ? changed : each)),
  );
}

export const removeTracks = (data: ClipData, ids: ReadonlySet<string>): ClipData =>
  withTracks(
    data,
    data.tracks.filter((track) => !ids.has(trackId(track))),
  );

/** Gives a track another address. @returns the same clip when a track with that address exists already */
export function retargetTrack(data: ClipData, from: TrackAddress, to: TrackAddress): ClipData {
  const track = findTrack(data, from);
  if (!track || findTrack(data, to)) return data;
  return withTracks(
    data,
    data.tracks.map((each) => (each === track ? { ...addressOf(to), keys: track.keys } : each)),
  );
}

/** Removes the selected keys, and tracks that are then empty. */
export function deleteKeys(data: ClipData, selected: KeySelection): ClipData {
  const tracks = data.tracks.flatMap((track) => {
    const isSelected = selectedIn(selected, track);
    if (isSelected === none) return track;
    const keys = track.keys.filter((key) => !isSelected(key));
    if (keys.length === track.keys.length) return track;
    return keys.length === 0 ? [] : { ...track, keys };
  });
  return withTracks(data, tracks);
}

/** Changes the times of the selected keys, replacing other keys at these times. @param timeOf - new time, 0 or more */
export function retimeKeys(data: ClipData, selected: KeySelection, timeOf: (time: number) => number): KeyEdit {
  const next = new Set<string>();
  const tracks = data.tracks.map((track) => {
    const isSelected = selectedIn(selected, track);
    if (isSelected === none) return track;
    const moved = track.keys.filter(isSelected).map((key) => ({ ...key, time: roundTime(timeOf(key.time)) }));
    if (moved.length === 0) return track;
    const staying = track.keys.filter((key) => !isSelected(key));
    const id = trackId(track);
    for (const { time } of moved) next.add(keyId(id, time));
    return { ...track, keys: insertKeys(staying, moved) };
  });
  return { data: withTracks(data, tracks), selected: next };
}

/** Times of the first and the last selected key (s); null when none is selected. */
export function rangeOfKeys(data: ClipData, selected: KeySelection): { first: number; last: number } | null {
  let [first, last] = [Infinity, -Infinity];
  eachSelected(data, selected, ({ time }) => {
    first = Math.min(first, time);
    last = Math.max(last, time);
  });
  return first > last ? null : { first, last };
}

/** Moves the selected keys; none of them before time 0. @param by - seconds */
export function moveKeys(data: ClipData, selected: KeySelection, by: number): KeyEdit {
  const range = rangeOfKeys(data, selected);
  if (!range) return { data, selected };
  const limited = Math.max(by, -range.first);
  return retimeKeys(data, selected, (time) => Math.max(time + limited, 0));
}

/** Scales the times of the selected keys about a fixed time. @param factor - 0 or more */
export function scaleKeys(
  data: ClipData,
  selected: KeySelection,
  pivot: number,
  factor: number,
  snap: (time: number) => number = (time) => time,
): KeyEdit {
  return retimeKeys(data, selected, (time) => Math.max(snap(pivot + (time - pivot) * factor), 0));
}

function changeKeys(data: ClipData, selected: KeySelection, change: (key: ClipKey) => ClipKey): ClipData {
  const tracks = data.tracks.map((track) => {
    const isSelected = selectedIn(selected, track);
    if (!track.keys.some(isSelected)) return track;
    return { ...track, keys: track.keys.map((key) => (isSelected(key) ? change(key) : key)) };
  });
  return withTracks(data, tracks);
}

/** Sets the easing from each selected key to the next. Booleans and choices always change in steps. */
export const easeKeys = (data: ClipData, selected: KeySelection, easing: Easing, control?: CurveControl): ClipData =>
  changeKeys(data, selected, ({ time, value }) => makeKey(time, value, easing, control));

/** Sets the value of each selected key, computed from the key. */
export const setValuesOfKeys = (
  data: ClipData,
  selected: KeySelection,
  valueOf: (before: FieldValue) => FieldValue,
): ClipData => changeKeys(data, selected, (key) => ({ ...key, value: valueOf(key.value) }));
