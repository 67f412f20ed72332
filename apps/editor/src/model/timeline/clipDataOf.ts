import { type ClipAsset, type ClipData, clipText, type ClipTrack } from '@farol/engine';
import { EMPTY_CLIP } from './clipTracks';

/** What was last read of a clip, or written to it: texts of many keys are read once. */
const known = new WeakMap<ClipAsset, { readonly text: string; readonly data: ClipData }>();

/** The text of a whole clip. */
const texts = new WeakMap<ClipData, string>();

/** The text of a track within that of its clip: of many tracks an edit changes few. */
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

/** The text of a clip, as of the engine's `clipText`: '' where nothing is in it. */
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

/** The tracks and events of a clip; the same object until they are edited. Of a text that is none of a clip nothing is left. */
export function clipDataOf(clip: ClipAsset): ClipData {
  const text = clip.getAuthored('data') as string;
  const last = known.get(clip);
  if (last?.text === text) return last.data;
  let data = EMPTY_CLIP;
  try {
    data = clip.clip;
  } catch {
    // whoever plays the clip tells of it
  }
  known.set(clip, { text, data });
  return data;
}

/** Notes what a text that a clip is about to have says. */
export const noteClipData = (clip: ClipAsset, text: string, data: ClipData): void => {
  known.set(clip, { text, data });
};
