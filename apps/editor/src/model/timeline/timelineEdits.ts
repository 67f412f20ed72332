/** Edits of the timeline's clip by the panel, its shortcuts and its menus; each is one step of the history. */
import { labelOfField, t, tCount } from '@farol/editing';
import type { ClipTrack, Easing } from '@farol/engine';
import { clipName } from './clipEdits';
import { findTrack, isSameTime, keyId, type TrackAddress, trackId } from './clipTracks';
import { copyKeys, type CopiedKeys, pasteKeys } from './copyKeys';
import type { CurveControl } from './easingCurve';
import { addEvent, removeEvents } from './editEvents';
import { deleteKeys, easeKeys, moveKeys, rangeOfKeys, removeTracks, retargetTrack, setKey } from './editKeys';
import { type KeyValue, withKeys } from './recordEdit';
import type { Timeline } from './Timeline';
import { type AnimatableField, addressOf, targetOf } from './trackTargets';

const nameOf = ({ clip }: Timeline): string => (clip ? clipName(clip) : '');

/** Label such as 'Moved 3 keys of Walk'. */
export const movedLabel = (timeline: Timeline, count: number): string =>
  tCount(count, 'Moved {count} key of {name}', 'Moved {count} keys of {name}', { name: nameOf(timeline) });

export const scaledLabel = (timeline: Timeline, count: number): string =>
  tCount(count, 'Scaled {count} key of {name}', 'Scaled {count} keys of {name}', { name: nameOf(timeline) });

const addedLabel = (timeline: Timeline, count: number): string =>
  tCount(count, 'Added {count} key to {name}', 'Added {count} keys to {name}', { name: nameOf(timeline) });

/**
 * Adds keys to tracks at the playhead, with the current value of the animated field, else the curve's; selects the
 * keys.
 */
export function addKeys(timeline: Timeline, tracks: readonly ClipTrack[]): void {
  const { root, time } = timeline;
  let { data } = timeline;
  for (const track of tracks) data = setKey(data, track, time, targetOf(root, track)?.get(track.field));
  const selected = new Set(tracks.map((track) => keyId(trackId(track), time)));
  if (tracks.length > 0) timeline.edit(addedLabel(timeline, tracks.length), { data, selected });
}

/** Adds a key to a track at a time, with the curve's value. */
export function addKeyOnCurve(timeline: Timeline, track: ClipTrack, time: number): void {
  const data = setKey(timeline.data, track, time);
  const selected = new Set([keyId(trackId(track), time)]);
  if (data !== timeline.data) timeline.edit(addedLabel(timeline, 1), { data, selected });
}

/** Adds keys of position, rotation and scale of the selected objects at the playhead. @returns whether any was added */
export function keyTransforms(timeline: Timeline): boolean {
  const { root, time, document } = timeline;
  if (!root) return false;
  const values = document.selectedObjects.flatMap(({ transform }) =>
    ['position', 'rotation', 'scale'].flatMap((field): KeyValue[] => {
      const address = addressOf(root, transform, field);
      if (!address) return [];
      return [{ address, value: transform.get(field), authored: transform.get(field) }];
    }),
  );
  if (values.length === 0) return false;
  const data = withKeys(timeline.data, values, time);
  const selected = new Set(values.map(({ address }) => keyId(trackId(address), time)));
  timeline.edit(addedLabel(timeline, values.length), { data, selected });
  return true;
}

/** Adds a track for a field, with a key of its current value at the playhead. */
export function addTrack(timeline: Timeline, { address, object, field }: AnimatableField): void {
  const target = targetOf(timeline.root, address);
  if (!target || findTrack(timeline.data, address)) return;
  const data = setKey(timeline.data, address, timeline.time, target.get(address.field));
  const selected = new Set([keyId(trackId(address), timeline.time)]);
  const label = t('Added a track for {field} of {object}', { field: field.toLowerCase(), object });
  timeline.edit(label, { data, selected });
}

export function deleteTracks(timeline: Timeline, tracks: readonly ClipTrack[]): void {
  if (tracks.length === 0) return;
  const name = nameOf(timeline);
  const label =
    tracks.length === 1
      ? t('Removed the track of {field} from {name}', { field: labelOfField(tracks[0].field, {}).toLowerCase(), name })
      : t('Removed {count} tracks from {name}', { count: tracks.length, name });
  timeline.edit(label, { data: removeTracks(timeline.data, new Set(tracks.map(trackId))), selected: new Set() });
}

/** Makes tracks without a target animate another object below the root. @param path - path of that object */
export function retargetTracks(timeline: Timeline, tracks: readonly ClipTrack[], path: string, object: string): void {
  const data = tracks.reduce((each, track) => retargetTrack(each, track, { ...track, path }), timeline.data);
  const label = t('Gave the tracks of {name} to {object}', { name: nameOf(timeline), object });
  if (data !== timeline.data) timeline.edit(label, { data, selected: new Set() });
}

export function deleteSelected(timeline: Timeline): void {
  const { data } = timeline;
  const { keys, events } = timeline.selection;
  const name = nameOf(timeline);
  if (keys.size > 0) {
    const label = tCount(keys.size, 'Deleted {count} key of {name}', 'Deleted {count} keys of {name}', { name });
    timeline.edit(label, { data: deleteKeys(data, keys), selected: new Set() });
  } else if (events.length > 0) {
    const label = tCount(events.length, 'Deleted {count} event of {name}', 'Deleted {count} events of {name}', {
      name,
    });
    timeline.edit(label, { data: removeEvents(data, events), selected: new Set() });
  }
}

/** The selected keys as text for the clipboard; null when there are none. */
export function copySelected({ data, selection }: Timeline): string | null {
  const copied = copyKeys(data, selection.keys);
  return copied && JSON.stringify(copied);
}

/**
 * Pastes keys at the playhead. @param onto - track for copied keys of a single track; each goes to its own when absent
 */
export function paste(timeline: Timeline, copied: CopiedKeys, onto?: TrackAddress): void {
  const edit = pasteKeys(timeline.data, copied, timeline.time, onto);
  const name = nameOf(timeline);
  timeline.edit(
    tCount(edit.selected.size, 'Pasted {count} key into {name}', 'Pasted {count} keys into {name}', { name }),
    edit,
  );
}

/** Inserts copies of the selected keys after the last of them. */
export function duplicateSelected(timeline: Timeline): void {
  const { data, selection, frameRate } = timeline;
  const copied = copyKeys(data, selection.keys);
  const range = rangeOfKeys(data, selection.keys);
  if (!copied || !range) return;
  const edit = pasteKeys(data, copied, timeline.snap(range.last + 1 / frameRate));
  const name = nameOf(timeline);
  timeline.edit(
    tCount(edit.selected.size, 'Duplicated {count} key of {name}', 'Duplicated {count} keys of {name}', { name }),
    edit,
  );
}

/** Moves the selected keys by a number of frames. */
export function nudgeSelected(timeline: Timeline, frames: number): void {
  const { data, selection, frameRate } = timeline;
  if (selection.keys.size === 0) return;
  const edit = moveKeys(data, selection.keys, frames / frameRate);
  timeline.edit(movedLabel(timeline, selection.keys.size), edit);
}

/** Sets the easing from each selected key to the next. */
export function easeSelected(timeline: Timeline, easing: Easing, control?: CurveControl): void {
  const { data, selection } = timeline;
  if (selection.keys.size === 0) return;
  const label = tCount(selection.keys.size, 'Eased {count} key of {name}', 'Eased {count} keys of {name}', {
    name: nameOf(timeline),
  });
  timeline.edit(label, easeKeys(data, selection.keys, easing, control));
}

export function addEventAt(timeline: Timeline, time: number): void {
  const { data, places } = addEvent(timeline.data, { time, method: 'onEvent' });
  timeline.edit(t('Added an event to {name}', { name: nameOf(timeline) }), { data, selected: new Set() }, places);
}

export const hasKeyAt = ({ keys }: ClipTrack, time: number): boolean => keys.some((key) => isSameTime(key.time, time));
