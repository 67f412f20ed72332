import { t } from '@farol/editing';
import { moveEvents } from '../../model/timeline/editEvents';
import { type KeySelection, moveKeys, rangeOfKeys, scaleKeys } from '../../model/timeline/editKeys';
import type { Timeline } from '../../model/timeline/Timeline';
import { movedLabel, scaledLabel } from '../../model/timeline/timelineEdits';
import { marksOfRow } from './drawTimeline';
import { firstMark, type KeyMarks, markNear, marksOfTracks } from './keyMarks';
import { editDrag, type SheetDrag } from './SheetDrag';
import { type Box, HEADER, type TimelineView } from './TimelineView';

/** Whether a press adds to the selection, or removes from it. */
export const addsToSelection = ({ shiftKey, ctrlKey, metaKey }: PointerEvent): boolean =>
  shiftKey || ctrlKey || metaKey;

/** Adds keys to a selection, or removes them when all are selected already. */
function toggled(selected: KeySelection, ids: readonly string[]): KeySelection {
  const next = new Set(selected);
  const isAll = ids.every((id) => selected.has(id));
  for (const id of ids) {
    if (isAll) next.delete(id);
    else next.add(id);
  }
  return next;
}

/** Selects pressed keys. When they are selected already, the selection is unchanged, since it may be dragged. */
export function choose(timeline: Timeline, ids: readonly string[], event: PointerEvent): void {
  const { keys } = timeline.selection;
  if (addsToSelection(event)) timeline.select(toggled(keys, ids));
  else if (!ids.every((id) => keys.has(id))) timeline.select(new Set(ids));
}

/** Selects only the clicked keys, unless the click adds to the selection. */
export function chooseAlone(timeline: Timeline, ids: readonly string[], event: PointerEvent): void {
  if (!addsToSelection(event)) timeline.select(new Set(ids));
}

/** Time at a position (s, 0 or above), snapped to a frame unless Alt is held. */
export function timeAt(view: TimelineView, x: number, event: { readonly altKey: boolean }): number {
  const time = Math.max(view.time(x), 0);
  return event.altKey ? time : view.timeline.snap(time);
}

/** Whether a position on the ruler is on the handle of the duration, rather than on the playhead. */
export function isAtEnd(view: TimelineView, x: number, reach: number): boolean {
  const { timeline } = view;
  const end = view.x(timeline.duration) + 3;
  return Math.abs(x - end) <= reach && Math.abs(x - end) < Math.abs(x - view.x(timeline.time));
}

/** Drags the handle of the clip's duration. */
export function dragDuration(view: TimelineView): SheetDrag {
  const { timeline } = view;
  const label = t('Set the duration of {name}', { name: timeline.clip?.name ?? '' });
  return editDrag(timeline, (gesture, x, _, event) =>
    gesture.previewDuration(label, Math.max(timeAt(view, x - 3, event), 1 / timeline.frameRate)),
  );
}

/** Selects the keys of a mark near a position, and drags the selection; null when no mark is near. */
export function dragMarks(
  view: TimelineView,
  marks: KeyMarks,
  x: number,
  reach: number,
  event: PointerEvent,
): SheetDrag | null {
  const { timeline } = view;
  const at = markNear(marks, view.time(x), reach / view.scale);
  if (at < 0) return null;
  const ids = marks.ids[at];
  choose(timeline, ids, event);
  return { ...moveSelected(view, marks.times[at], x), click: () => chooseAlone(timeline, ids, event) };
}

/** Moves the selection. @param anchor - time that snaps to frames @param from - position of the press (CSS pixels) */
export function moveSelected(view: TimelineView, anchor: number, from: number): SheetDrag {
  const { timeline } = view;
  const { keys } = timeline.selection;
  return editDrag(timeline, (gesture, x, _, event) => {
    const time = anchor + (x - from) / view.scale;
    const by = (event.altKey ? time : timeline.snap(time)) - anchor;
    gesture.preview(movedLabel(timeline, keys.size), moveKeys(gesture.data, keys, by));
  });
}

/**
 * Scales the selected keys in time; null when none is selected.
 * @param isEnd - drags the last key, about the first; else the reverse
 * @param from - position of the press (CSS pixels)
 */
export function scaleSelected(view: TimelineView, isEnd: boolean, from: number): SheetDrag | null {
  const { timeline } = view;
  const { keys } = timeline.selection;
  const range = rangeOfKeys(timeline.data, keys);
  if (!range) return null;
  const [pivot, dragged] = isEnd ? [range.first, range.last] : [range.last, range.first];
  return editDrag(timeline, (gesture, x, _, event) => {
    const factor = Math.max((dragged + (x - from) / view.scale - pivot) / (dragged - pivot), 0);
    const snap = event.altKey ? undefined : timeline.snap;
    gesture.preview(scaledLabel(timeline, keys.size), scaleKeys(gesture.data, keys, pivot, factor, snap));
  });
}

/** Selects the event near a position, and drags the selected events; null when no event is near. */
export function dragEvent(view: TimelineView, x: number, reach: number, event: PointerEvent): SheetDrag | null {
  const { timeline } = view;
  const { events } = timeline.data;
  const at = events.findLastIndex(({ time }) => x >= view.x(time) - reach && x <= view.x(time) + Math.max(reach, 9));
  if (at < 0) return null;
  const { events: before } = timeline.selection;
  if (addsToSelection(event)) {
    const places = before.includes(at) ? before.filter((place) => place !== at) : [...before, at];
    timeline.select(new Set(), places);
  } else if (!before.includes(at)) timeline.select(new Set(), [at]);
  const { events: places } = timeline.selection;
  const anchor = events[at].time;
  return editDrag(timeline, (gesture, to, _, moved) => {
    if (places.length === 0) return;
    const time = anchor + (to - x) / view.scale;
    const edit = moveEvents(gesture.data, places, (moved.altKey ? time : timeline.snap(time)) - anchor);
    const name = timeline.clip?.name ?? '';
    gesture.preview(t('Moved events of {name}', { name }), edit.data, edit.places);
  });
}

/** The keys whose marks are within a box; keys of all rows when the box begins in the header. */
export function keysInBox(view: TimelineView, { x0, y0, x1, y1 }: Box): string[] {
  const { timeline } = view;
  const [top, bottom] = [Math.min(y0, y1), Math.max(y0, y1)];
  const [first, last] = [view.time(Math.min(x0, x1)), view.time(Math.max(x0, x1))];
  const ids: string[] = [];
  const add = (marks: KeyMarks): void => {
    for (let i = firstMark(marks, first); i < marks.times.length && marks.times[i] <= last; i++)
      ids.push(...marks.ids[i]);
  };
  if (y0 < HEADER) {
    add(marksOfTracks(timeline.data.tracks));
    return ids;
  }
  view.rows.forEach((row, i) => {
    const middle = view.rowTop(i) + view.rowHeight / 2;
    const marks = middle >= top && middle <= bottom ? marksOfRow(row) : null;
    if (marks) add(marks);
  });
  return ids;
}
