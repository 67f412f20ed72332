import { type ClipAsset, type ClipData, type ClipEvent, type ClipKey, type ClipTrack } from '@farol/engine';
import { EMPTY_CLIP } from './clipTracks';

type Unknown = Readonly<Record<string, unknown>>;

/** What was last read of a clip, or written to it: texts of many keys are read once. */
const known = new WeakMap<ClipAsset, { readonly text: string; readonly data: ClipData }>();

const isTime = (time: unknown): time is number => typeof time === 'number' && time >= 0;

const isKey = (key: unknown): key is ClipKey => isTime((key as Unknown | null)?.time) && 'value' in (key as Unknown);

const isTrack = (track: unknown): track is ClipTrack => {
  const { path, component, field, keys } = (track ?? {}) as Unknown;
  return [path, component, field].every((each) => typeof each === 'string') && Array.isArray(keys);
};

const isEvent = (event: unknown): event is ClipEvent =>
  isTime((event as Unknown | null)?.time) && typeof (event as Unknown).method === 'string';

const listOf = (value: unknown): readonly unknown[] => (Array.isArray(value) ? value : []);

const inOrder = (a: { readonly time: number }, b: { readonly time: number }): number => a.time - b.time;

/** Reads the text of a clip. What is no track, key or event is left out; of broken text nothing is left. */
export function readClip(text: string): ClipData {
  if (text === '') return EMPTY_CLIP;
  let read: Unknown | null;
  try {
    read = JSON.parse(text) as Unknown | null;
  } catch {
    return EMPTY_CLIP;
  }
  const tracks = listOf(read?.tracks).filter(isTrack);
  return {
    tracks: tracks.map((track) => ({ ...track, keys: track.keys.filter(isKey).toSorted(inOrder) })),
    events: listOf(read?.events).filter(isEvent).toSorted(inOrder),
  };
}

/** The text of a clip: '' where nothing is in it. */
export const writeClip = (data: ClipData): string =>
  data.tracks.length === 0 && data.events.length === 0 ? '' : JSON.stringify(data);

/** The tracks and events of a clip; the same object until they are edited. */
export function clipDataOf(clip: ClipAsset): ClipData {
  const text = clip.getAuthored('data') as string;
  const last = known.get(clip);
  if (last?.text === text) return last.data;
  const data = readClip(text);
  known.set(clip, { text, data });
  return data;
}

/** Notes what a text that a clip is about to have says. */
export const noteClipData = (clip: ClipAsset, text: string, data: ClipData): void => {
  known.set(clip, { text, data });
};
