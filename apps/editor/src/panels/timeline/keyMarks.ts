import type { ClipData, ClipTrack } from '@farol/engine';
import { keyId, SAME_TIME, trackId } from '../../model/timeline/clipTracks';
import type { KeySelection } from '../../model/timeline/editKeys';

/** The keys of a row, sorted by time: one mark for each time, which stands for one key or for several. */
export interface KeyMarks {
  readonly times: readonly number[];
  /** Ids of the keys that each mark stands for. */
  readonly ids: readonly (readonly string[])[];
}

const ofTracks = new WeakMap<ClipTrack, KeyMarks>();
const ofLists = new WeakMap<readonly ClipTrack[], KeyMarks>();

/** The marks of a track; the same object as long as the track is the same. */
export function marksOfTrack(track: ClipTrack): KeyMarks {
  let marks = ofTracks.get(track);
  if (!marks) {
    const id = trackId(track);
    const times = track.keys.map(({ time }) => time);
    marks = { times, ids: times.map((time) => [keyId(id, time)]) };
    ofTracks.set(track, marks);
  }
  return marks;
}

/** The marks of several tracks together. @param tracks - key of a cache: the same array gives the same marks */
export function marksOfTracks(tracks: readonly ClipTrack[]): KeyMarks {
  let marks = ofLists.get(tracks);
  if (!marks) {
    const byTime = new Map<number, { time: number; ids: string[] }>();
    for (const track of tracks) {
      const { times, ids } = marksOfTrack(track);
      for (let i = 0; i < times.length; i++) {
        const place = Math.round(times[i] / SAME_TIME);
        const mark = byTime.get(place);
        if (mark) mark.ids.push(ids[i][0]);
        else byTime.set(place, { time: times[i], ids: [...ids[i]] });
      }
    }
    const list = [...byTime.values()].toSorted((a, b) => a.time - b.time);
    marks = { times: list.map(({ time }) => time), ids: list.map(({ ids }) => ids) };
    ofLists.set(tracks, marks);
  }
  return marks;
}

/** Index of the first mark at or after a time. */
export function firstMark({ times }: KeyMarks, time: number): number {
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] < time) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Index of the mark nearest to a time, within a reach (s); -1 for none. */
export function markNear(marks: KeyMarks, time: number, reach: number): number {
  const { times } = marks;
  let nearest = -1;
  for (let i = firstMark(marks, time - reach); i < times.length && times[i] <= time + reach; i++) {
    if (nearest < 0 || Math.abs(times[i] - time) < Math.abs(times[nearest] - time)) nearest = i;
  }
  return nearest;
}

export const isMarkSelected = (ids: readonly string[], selected: KeySelection): boolean =>
  ids.every((id) => selected.has(id));

/** Time of the next (1) or previous (-1) key; null when there is none. */
export function nextKeyTime({ tracks }: ClipData, time: number, direction: 1 | -1): number | null {
  const marks = marksOfTracks(tracks);
  const { times } = marks;
  const at = direction > 0 ? firstMark(marks, time + SAME_TIME * 2) : firstMark(marks, time - SAME_TIME * 2) - 1;
  return times[at] ?? null;
}
