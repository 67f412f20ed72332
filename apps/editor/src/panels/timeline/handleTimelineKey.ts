import { latinKey } from '@farol/editing';
import type { KeyboardEvent } from 'react';
import type { EditorApi } from '../../api/EditorApi';
import { keyId, SAME_TIME, trackId } from '../../model/timeline/clipTracks';
import { readCopiedKeys } from '../../model/timeline/copyKeys';
import { allKeys, rangeOfKeys } from '../../model/timeline/editKeys';
import {
  addKeys,
  copySelected,
  deleteSelected,
  duplicateSelected,
  nudgeSelected,
  paste,
} from '../../model/timeline/timelineEdits';
import { nextKeyTime } from './keyMarks';
import { valuesOfCurves } from './shownCurves';
import type { TimelineView } from './TimelineView';
import { tracksForKeys } from './tracksForKeys';

/** Zooms to the selection, or to the whole clip. */
export function frameSelected(view: TimelineView): void {
  const { data, selection, duration } = view.timeline;
  const range = rangeOfKeys(data, selection.keys);
  const [first, last] = range && range.last > range.first ? [range.first, range.last] : [0, duration];
  const values = view.mode === 'curves' ? valuesOfCurves(view, first, last) : null;
  if (values) view.frame(first, last, ...values);
  else if (range && range.last > range.first) view.frame(first, last);
  else view.fit();
}

/** Selects the keys at the playhead, in the chosen rows, or in all when none is chosen. */
function selectAtPlayhead(view: TimelineView): void {
  const { timeline } = view;
  const ids = tracksForKeys(view).flatMap((track) =>
    track.keys
      .filter(({ time }) => Math.abs(time - timeline.time) < 0.5 / timeline.frameRate + SAME_TIME)
      .map(({ time }) => keyId(trackId(track), time)),
  );
  timeline.select(new Set(ids));
}

/** Copies the selected keys to the editor's clipboard. @returns whether there were any */
export function copyToClipboard({ clipboard }: EditorApi, view: TimelineView): boolean {
  const text = copySelected(view.timeline);
  if (text !== null) clipboard.text = text;
  return text !== null;
}

/** Pastes keys from the clipboard; keys of one track go to the chosen track when exactly one is chosen. */
export function pasteFromClipboard({ clipboard }: EditorApi, view: TimelineView): void {
  const copied = readCopiedKeys(clipboard.text ?? '');
  const chosen = view.chosen.size === 0 ? [] : tracksForKeys(view);
  const kindOf = (value: unknown): string => (Array.isArray(value) ? 'triple' : typeof value);
  const [onto] = chosen;
  const fits = chosen.length === 1 && kindOf(onto.keys[0]?.value) === kindOf(copied?.tracks[0]?.keys[0]?.value);
  if (copied) paste(view.timeline, copied, fits ? onto : undefined);
}

/**
 * Handles a key in the timeline. Fields, buttons and menus of the panel keep their own keys.
 * @returns whether the key was handled, so that other handlers must ignore it
 */
export function handleTimelineKey(editor: EditorApi, view: TimelineView, event: KeyboardEvent): boolean {
  const { timeline } = view;
  const target = event.target as HTMLElement;
  if (!timeline.clip || event.defaultPrevented) return false;
  const isSheet = target.closest('.timeline-sheet') !== null;
  if (!isSheet && (target.closest('input, [role="menu"], [role="listbox"]') || !target.closest('.timeline-body')))
    return false;
  const goTo = (time: number | null): void => {
    timeline.pause();
    if (time !== null) timeline.setTime(time);
    view.reveal(timeline.time);
  };
  const steps = (frames: number) => () => {
    timeline.pause();
    timeline.stepFrames(frames);
    view.reveal(timeline.time);
  };
  const acts: Record<string, () => void> = {
    'Ctrl+c': () => copyToClipboard(editor, view),
    'Ctrl+x': () => copyToClipboard(editor, view) && deleteSelected(timeline),
    'Ctrl+v': () => pasteFromClipboard(editor, view),
    'Ctrl+d': () => duplicateSelected(timeline),
    'Ctrl+a': () => timeline.select(allKeys(timeline.data)),
    f: () => frameSelected(view),
    Delete: () => deleteSelected(timeline),
    Backspace: () => deleteSelected(timeline),
  };
  if (isSheet) {
    Object.assign(acts, {
      ArrowLeft: steps(-1),
      ArrowRight: steps(1),
      'Shift+ArrowLeft': steps(-10),
      'Shift+ArrowRight': steps(10),
      'Ctrl+ArrowLeft': () => goTo(nextKeyTime(timeline.data, timeline.time, -1)),
      'Ctrl+ArrowRight': () => goTo(nextKeyTime(timeline.data, timeline.time, 1)),
      'Alt+ArrowLeft': () => nudgeSelected(timeline, -1),
      'Alt+ArrowRight': () => nudgeSelected(timeline, 1),
      Home: () => goTo(0),
      End: () => goTo(timeline.duration),
      Enter: () => selectAtPlayhead(view),
      Insert: () => addKeys(timeline, tracksForKeys(view)),
    });
  }
  const modifiers = `${event.ctrlKey || event.metaKey ? 'Ctrl+' : ''}${event.altKey ? 'Alt+' : ''}${event.shiftKey ? 'Shift+' : ''}`;
  const key = latinKey(event);
  const name = modifiers + (key.length === 1 ? key.toLowerCase() : key);
  if (name === 'Escape' && (timeline.selection.keys.size > 0 || timeline.selection.events.length > 0)) {
    timeline.select(new Set());
    return true;
  }
  if (!Object.hasOwn(acts, name)) return false;
  editor.attempt(acts[name]);
  return true;
}
