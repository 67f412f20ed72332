import type { ClipData, ClipKey } from '@farol/engine';
import { findTrack, keyId, roundTime, type TrackAddress, trackId } from './clipTracks';
import { insertKeys, type KeyEdit, type KeySelection, rangeOfKeys, selectedIn } from './editKeys';

/** Copied keys; times are relative to the first one. */
export interface CopiedKeys {
  readonly kind: 'farol-keys';
  readonly tracks: readonly (TrackAddress & { readonly keys: readonly ClipKey[] })[];
}

/** Copies the selected keys; null when there are none. */
export function copyKeys(data: ClipData, selected: KeySelection): CopiedKeys | null {
  const range = rangeOfKeys(data, selected);
  if (!range) return null;
  const tracks = data.tracks.flatMap((track) => {
    const keys = track.keys.filter(selectedIn(selected, track));
    if (keys.length === 0) return [];
    return { ...track, keys: keys.map((key) => ({ ...key, time: key.time - range.first })) };
  });
  return { kind: 'farol-keys', tracks };
}

/** Parses text made from `copyKeys`; null when it is something else. */
export function readCopiedKeys(text: string): CopiedKeys | null {
  if (!text.includes('"farol-keys"')) return null;
  try {
    const read = JSON.parse(text) as Partial<CopiedKeys> | null;
    const isWhole =
      read?.kind === 'farol-keys' && read.tracks!.every(({ keys }) => keys.every(({ time }) => Number.isFinite(time)));
    return isWhole ? (read as CopiedKeys) : null;
  } catch {
    return null;
  }
}

/**
 * Pastes keys at a time, replacing existing keys and adding missing tracks.
 * @param onto - track for copied keys of a single track; each key's own track when absent
 * @returns the clip, with the pasted keys selected
 */
export function pasteKeys(data: ClipData, copied: CopiedKeys, time: number, onto?: TrackAddress): KeyEdit {
  const selected = new Set<string>();
  let { tracks } = data;
  for (const source of copied.tracks) {
    const { path, component, field } = copied.tracks.length === 1 && onto ? onto : source;
    const address = { path, component, field };
    const pasted = source.keys.map((key) => ({ ...key, time: roundTime(key.time + time) }));
    for (const key of pasted) selected.add(keyId(trackId(address), key.time));
    const track = findTrack({ ...data, tracks }, address);
    if (!track) tracks = [...tracks, { ...address, keys: pasted }];
    else {
      const changed = { ...track, keys: insertKeys(track.keys, pasted) };
      tracks = tracks.map((each) => (each === track ? changed : each));
    }
  }
  return { data: { ...data, tracks }, selected };
}
