import { t } from '@farol/editing';
import { moveEvents } from '../../model/timeline/editEvents';
import { type KeySelection, moveKeys, rangeOfKeys, scaleKeys, selectedKeys } from '../../model/timeline/editKeys';
import type { ClipGesture, Timeline } from '../../model/timeline/Timeline';
import { addEventAt, addKeyOnCurve, movedLabel, scaledLabel } from '../../model/timeline/timelineEdits';
import { GRIP, marksOfRow, selectionBar } from './drawTimeline';
import {
  dragCurveKey,
  dragHandle,
  keysInCurveBox,
  nearestCurveKey,
  nearestHandle,
  trackOfCurveAt,
} from './curvePointer';
import { type KeyMarks, markNear, marksOfTracks, firstMark } from './keyMarks';
import { HEADER, RULER, type TimelineView } from './TimelineView';

/** Handler of a press and its drag. Positions are CSS pixels of the canvas. */
export interface SheetDrag {
  /** Called when the press becomes a drag. */
  begin?(): void;
  move(x: number, y: number, event: PointerEvent): void;
  /** @param keeps - whether the result is kept */
  end(keeps: boolean): void;
  /** Called when the pointer is released without a drag. */
  click?(event: PointerEvent): void;
}

/** Distance (CSS pixels) below which a press is a click. */
const SLOP = 3;

/** Adds keys to a selection, or removes them when all are selected already. */
export function toggled(selected: KeySelection, ids: readonly string[]): KeySelection {
  const next = new Set(selected);
  const isAll = ids.every((id) => selected.has(id));
  for (const id of ids) {
    if (isAll) next.delete(id);
    else next.add(id);
  }
  return next;
}

/**
 * Pointer input on the timeline's canvas: scrubbing, selecting, dragging keys, events and handles, box selection,
 * panning and zooming.
 */
export class TimelinePointer {
  private readonly timeline: Timeline;
  /** Positions of fingers that are down, by pointer id. */
  private readonly fingers = new Map<number, { x: number; y: number }>();
  private current: { drag: SheetDrag; end(keeps: boolean): void } | null = null;

  /** @param scroll - scrolls the tracks vertically (CSS pixels) */
  constructor(
    private readonly view: TimelineView,
    private readonly element: HTMLElement,
    private readonly scroll: (by: number) => void,
  ) {
    this.timeline = view.timeline;
  }

  /** Listens until the signal is aborted. */
  listen(signal: AbortSignal): void {
    this.element.addEventListener('pointerdown', (event) => this.press(event), { signal });
    this.element.addEventListener('dblclick', (event) => this.doubleClick(event), { signal });
    this.element.addEventListener('wheel', (event) => this.wheel(event), { signal, passive: false });
    signal.addEventListener('abort', () => this.current?.end(false));
  }

  private place(event: MouseEvent): { x: number; y: number } {
    const { left, top } = this.element.getBoundingClientRect();
    return { x: event.clientX - left, y: event.clientY - top };
  }

  private press(event: PointerEvent): void {
    const { x, y } = this.place(event);
    if (event.pointerType === 'touch') {
      this.fingers.set(event.pointerId, { x, y });
      if (this.fingers.size === 2) {
        this.current?.end(false);
        this.run(event, this.pinch());
        return;
      }
    }
    if (this.current || event.button > 1) return;
    // prevents text selection, and scrolling by the middle button
    event.preventDefault();
    const reach = event.pointerType === 'touch' ? 16 : 7;
    const drag = event.button === 1 ? this.pan(x, y) : this.dragAt(x, y, reach, event);
    if (drag) this.run(event, drag);
  }

  /** Follows the pointer until it is released, or Escape is pressed. */
  private run(down: PointerEvent, drag: SheetDrag): void {
    const { element, fingers } = this;
    const over = new AbortController();
    const options = { signal: over.signal, capture: true };
    const from = this.place(down);
    let hasBegun = false;
    element.setPointerCapture(down.pointerId);
    const end = (keeps: boolean, event?: PointerEvent): void => {
      over.abort();
      this.current = null;
      fingers.clear();
      if (hasBegun) drag.end(keeps);
      else if (keeps && event) drag.click?.(event);
    };
    this.current = { drag, end };
    addEventListener(
      'pointermove',
      (event) => {
        const place = this.place(event);
        if (fingers.has(event.pointerId)) fingers.set(event.pointerId, place);
        if (event.pointerId !== down.pointerId && fingers.size < 2) return;
        if (!hasBegun) {
          if (Math.hypot(place.x - from.x, place.y - from.y) < SLOP) return;
          hasBegun = true;
          drag.begin?.();
        }
        drag.move(place.x, place.y, event);
      },
      options,
    );
    addEventListener(
      'pointerup',
      (event) => (fingers.has(event.pointerId) || event.pointerId === down.pointerId ? end(true, event) : undefined),
      options,
    );
    addEventListener('pointercancel', (event) => event.pointerId === down.pointerId && end(false), options);
    addEventListener('blur', (event) => event.target === window && end(false), options);
    addEventListener(
      'keydown',
      (event) => {
        if (event.key !== 'Escape') return;
        event.preventDefault();
        event.stopPropagation();
        end(false);
      },
      options,
    );
  }

  private dragAt(x: number, y: number, reach: number, event: PointerEvent): SheetDrag | null {
    const { view, timeline } = this;
    if (y < RULER) return this.isAtEnd(x, reach) ? this.dragDuration() : this.scrub(x, event);
    if (y < HEADER) {
      const bar = selectionBar(view);
      const marks = marksOfTracks(timeline.data.tracks);
      const mark = markNear(marks, view.time(x), reach / view.scale);
      /** Horizontal distance from the pointer to a position (CSS pixels). */
      const far = (at: number): number => Math.abs(x - at);
      const toMark = mark < 0 ? Infinity : far(view.x(marks.times[mark]));
      if (bar && far(bar.x1 + GRIP) <= Math.min(reach, toMark)) return this.scale(true, x);
      if (bar && far(bar.x0 - GRIP) <= Math.min(reach, toMark)) return this.scale(false, x);
      const drag = this.dragMarks(marks, x, reach, event);
      if (drag) return drag;
      if (bar && x > bar.x0 && x < bar.x1) return this.moveSelected(view.time(x), x);
      return this.boxOrPan(x, y, event);
    }
    if (view.mode === 'curves') {
      const handle = nearestHandle(view, x, y, reach);
      if (handle) return dragHandle(view, handle);
      const key = nearestCurveKey(view, x, y, reach + 1);
      if (!key) return this.boxOrPan(x, y, event);
      this.choose([key.id], event);
      const drag = dragCurveKey(view, key, { x, y });
      return { ...drag, click: () => this.chooseAlone([key.id], event) };
    }
    const row = view.rows[view.rowAt(y)];
    if (row?.kind === 'events') return this.dragEvent(x, reach, event) ?? this.boxOrPan(x, y, event);
    const marks = row && marksOfRow(row);
    return (marks && this.dragMarks(marks, x, reach, event)) ?? this.boxOrPan(x, y, event);
  }

  /** Whether a position on the ruler is the handle of the duration, rather than the playhead. */
  private isAtEnd(x: number, reach: number): boolean {
    const { view, timeline } = this;
    const end = view.x(timeline.duration) + 3;
    return Math.abs(x - end) <= reach && Math.abs(x - end) < Math.abs(x - view.x(timeline.time));
  }

  private timeAt(x: number, event: { readonly altKey: boolean }): number {
    const time = Math.max(this.view.time(x), 0);
    return event.altKey ? time : this.timeline.snap(time);
  }

  private scrub(x: number, event: PointerEvent): SheetDrag {
    this.timeline.pause();
    this.timeline.setTime(this.timeAt(x, event));
    return {
      move: (to, _, moved) => this.timeline.setTime(this.timeAt(to, moved)),
      end: () => {},
    };
  }

  private dragDuration(): SheetDrag {
    let gesture: ClipGesture | null = null;
    const { timeline } = this;
    const label = t('Set the duration of {name}', { name: timeline.clip?.name ?? '' });
    return {
      begin: () => (gesture = timeline.beginEdit()),
      move: (x, _, event) =>
        gesture?.previewDuration(label, Math.max(this.timeAt(x - 3, event), 1 / timeline.frameRate)),
      end: (keeps) => (keeps ? gesture?.commit() : gesture?.discard()),
    };
  }

  /** Selects pressed keys. Keys that are selected already stay so, since they may be dragged. */
  private choose(ids: readonly string[], event: PointerEvent): void {
    const { timeline } = this;
    const { keys } = timeline.selection;
    if (event.shiftKey || event.ctrlKey || event.metaKey) timeline.select(toggled(keys, ids));
    else if (!ids.every((id) => keys.has(id))) timeline.select(new Set(ids));
  }

  private chooseAlone(ids: readonly string[], event: PointerEvent): void {
    if (!event.shiftKey && !event.ctrlKey && !event.metaKey) this.timeline.select(new Set(ids));
  }

  private dragMarks(marks: KeyMarks, x: number, reach: number, event: PointerEvent): SheetDrag | null {
    const { view } = this;
    const at = markNear(marks, view.time(x), reach / view.scale);
    if (at < 0) return null;
    const ids = marks.ids[at];
    this.choose(ids, event);
    return { ...this.moveSelected(marks.times[at], x), click: () => this.chooseAlone(ids, event) };
  }

  /** Moves the selection. @param anchor - time that snaps to frames @param from - position of the press */
  private moveSelected(anchor: number, from: number): SheetDrag {
    const { view, timeline } = this;
    let gesture: ClipGesture | null = null;
    const { keys } = timeline.selection;
    return {
      begin: () => (gesture = timeline.beginEdit()),
      move: (x, _, event) => {
        if (!gesture) return;
        const time = anchor + (x - from) / view.scale;
        const by = (event.altKey ? time : timeline.snap(time)) - anchor;
        gesture.preview(movedLabel(timeline, keys.size), moveKeys(gesture.data, keys, by));
      },
      end: (keeps) => (keeps ? gesture?.commit() : gesture?.discard()),
    };
  }

  /**
   * Scales the selected keys in time. @param isEnd - drags the last key, about the first; else the reverse @param from
   * - position of the press
   */
  private scale(isEnd: boolean, from: number): SheetDrag | null {
    const { view, timeline } = this;
    const { keys } = timeline.selection;
    const range = rangeOfKeys(timeline.data, keys);
    if (!range) return null;
    const [pivot, dragged] = isEnd ? [range.first, range.last] : [range.last, range.first];
    let gesture: ClipGesture | null = null;
    return {
      begin: () => (gesture = timeline.beginEdit()),
      move: (x, _, event) => {
        if (!gesture) return;
        const factor = Math.max((dragged + (x - from) / view.scale - pivot) / (dragged - pivot), 0);
        const snap = event.altKey ? undefined : timeline.snap;
        gesture.preview(scaledLabel(timeline, keys.size), scaleKeys(gesture.data, keys, pivot, factor, snap));
      },
      end: (keeps) => (keeps ? gesture?.commit() : gesture?.discard()),
    };
  }

  private dragEvent(x: number, reach: number, event: PointerEvent): SheetDrag | null {
    const { view, timeline } = this;
    const { events } = timeline.data;
    const at = events.findLastIndex(({ time }) => x >= view.x(time) - reach && x <= view.x(time) + Math.max(reach, 9));
    if (at < 0) return null;
    const { events: before } = timeline.selection;
    if (event.shiftKey || event.ctrlKey || event.metaKey) {
      const places = before.includes(at) ? before.filter((place) => place !== at) : [...before, at];
      timeline.select(new Set(), places);
    } else if (!before.includes(at)) timeline.select(new Set(), [at]);
    const { events: places } = timeline.selection;
    const anchor = events[at].time;
    let gesture: ClipGesture | null = null;
    return {
      begin: () => (gesture = timeline.beginEdit()),
      move: (to, _, moved) => {
        if (!gesture || places.length === 0) return;
        const time = anchor + (to - x) / view.scale;
        const edit = moveEvents(gesture.data, places, (moved.altKey ? time : timeline.snap(time)) - anchor);
        const name = timeline.clip?.name ?? '';
        gesture.preview(t('Moved events of {name}', { name }), edit.data, edit.places);
      },
      end: (keeps) => (keeps ? gesture?.commit() : gesture?.discard()),
    };
  }

  /** A press on empty space: a mouse draws a selection box, a finger pans. */
  private boxOrPan(x: number, y: number, event: PointerEvent): SheetDrag {
    const { timeline, view } = this;
    const adds = event.shiftKey || event.ctrlKey || event.metaKey;
    const click = (): void => {
      if (!adds) timeline.select(new Set());
      if (view.chosen.size > 0 && view.mode === 'keys') view.set('chosen', new Set());
    };
    if (event.pointerType === 'touch') return { ...this.pan(x, y), click };
    const before = adds ? timeline.selection.keys : new Set<string>();
    return {
      move: (x1, y1) => {
        view.box = { x0: x, y0: y, x1, y1 };
        const inside = view.mode === 'curves' && y >= HEADER ? keysInCurveBox(view, view.box) : this.keysInBox();
        timeline.select(new Set([...before, ...inside]));
      },
      end: (keeps) => {
        view.box = null;
        if (!keeps) timeline.select(before);
        view.draw();
      },
      click,
    };
  }

  private keysInBox(): string[] {
    const { view, timeline } = this;
    const { x0, y0, x1, y1 } = view.box!;
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

  private pan(x: number, y: number): SheetDrag {
    let last = { x, y };
    return {
      move: (toX, toY) => {
        this.view.pan(toX - last.x, toY - last.y);
        if (this.view.mode === 'keys') this.scroll(last.y - toY);
        last = { x: toX, y: toY };
      },
      end: () => {},
    };
  }

  /** Two fingers: pan and zoom. */
  private pinch(): SheetDrag {
    const { view, fingers } = this;
    const read = (): { x: number; distance: number } => {
      const [a, b] = [...fingers.values()];
      return { x: (a.x + b.x) / 2, distance: Math.max(Math.hypot(a.x - b.x, a.y - b.y), 10) };
    };
    let last = read();
    return {
      move: () => {
        if (fingers.size < 2) return;
        const next = read();
        view.pan(next.x - last.x);
        view.zoom(next.distance / last.distance, next.x);
        last = next;
      },
      end: () => {},
    };
  }

  private doubleClick(event: MouseEvent): void {
    const { view, timeline } = this;
    const { x, y } = this.place(event);
    if (y < HEADER || !timeline.clip) return;
    const time = this.timeAt(x, event);
    if (view.mode === 'curves') {
      const track = trackOfCurveAt(view, x, y);
      if (track) addKeyOnCurve(timeline, track, time);
      return;
    }
    const row = view.rows[view.rowAt(y)];
    if (row?.kind === 'events') addEventAt(timeline, time);
    else if (row?.kind === 'track' && selectedKeys(timeline.data, timeline.selection.keys).length === 0)
      addKeyOnCurve(timeline, row.track, time);
  }

  private wheel(event: WheelEvent): void {
    const { view } = this;
    const { x, y } = this.place(event);
    event.preventDefault();
    const unit = event.deltaMode === 1 ? 16 : 1;
    const [deltaX, deltaY] = [event.deltaX * unit, event.deltaY * unit];
    const isCurves = view.mode === 'curves';
    if (event.shiftKey) {
      const by = deltaY || deltaX;
      if (isCurves) view.zoomValues(Math.exp(-by / 400), y);
      else this.scroll(by);
      return;
    }
    if (Math.abs(deltaX) > Math.abs(deltaY)) view.pan(-deltaX);
    else view.zoom(Math.exp(-deltaY / 400), x);
    if (isCurves && event.ctrlKey) view.zoomValues(Math.exp(-deltaY / 400), y);
  }
}
