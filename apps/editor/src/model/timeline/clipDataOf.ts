import { type ClipAsset, type ClipData, clipText, type ClipTrack } from '@farol/engine';
import type { TrackAddress } from './clipTracks';

export const EMPTY_CLIP: ClipData = { tracks: [], events: [] };

/** Id of a track within its clip. */
export const trackId = ({ path, component, field }: TrackAddress): string => `${path}\n${component}\n${field}`;

/** Parsed data of each clip, with the text it was parsed from or written to; saves parsing long texts again. */
const known = new WeakMap<ClipAsset, { readonly text: string; readonly data: ClipData }>();

/** Serialised text of each clip's data. */
const texts = new WeakMap<ClipData, string>();

/** Serialised text of each track: an edit changes only some tracks. */
const trackTexts = new WeakMap<ClipTrack, string>();

const [BEFORE, AFTER] = ['{"tracks":[', '],"events":[]}'];

function textOfTrack(track: ClipTrack): string {
  let text = trackTexts.get(track);
  if (text === undefined) {
    text = clipText({ tracks: [track], events: [] }).slice(BEFORE.length, -AFTER.length);
    trackTexts.set(track, text);
  }
  return text;
}

/** Serialises a clip as the engine's `clipText` does; '' when it is empty. */
export function writeClip(data: ClipData): string {
  const { tracks, events } = data;
  if (tracks.length === 0 && events.length === 0) return '';
  let text = texts.get(data);
  if (text === undefined) {
    const rest = clipText({ tracks: [], events }).slice(BEFORE.length);
    text = BEFORE + tracks.map(textOfTrack).join() + rest;
    texts.set(data, text);
  }
  return text;
}

/** Tracks and events of a clip: the same object until the clip is edited. Empty when the text is malformed. */
export function clipDataOf(clip: ClipAsset): ClipData {
  const text = clip.getAuthored('data') as string;
  const last = known.get(clip);
  if (last?.text === text) return last.data;
  let data = EMPTY_CLIP;
  try {
    data = clip.clip;
  } catch {
    // the text is malformed: the component that plays the clip reports it
  }
  known.set(clip, { text, data });
  return data;
}

/** Stores the parsed data for the text that a clip is about to have. */
export const noteClipData = (clip: ClipAsset, text: string, data: ClipData): void => {
  known.set(clip, { text, data });
};
