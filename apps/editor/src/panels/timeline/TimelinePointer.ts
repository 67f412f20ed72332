import { selectedKeys } from '../../model/timeline/editKeys';
import type { Timeline } from '../../model/timeline/Timeline';
import { addEventAt, addKeyOnCurve } from '../../model/timeline/timelineEdits';
import {
  dragCurveKey,
  dragHandle,
  keysInCurveBox,
  nearestCurveKey,
  nearestHandle,
  trackOfCurveAt,
} from './curvePointer';
import { GRIP, marksOfRow, selectionBar } from './drawTimeline';
import { marksOfTracks, markNear } from './keyMarks';
import type { SheetDrag } from './SheetDrag';
import {
  addsToSelection,
  choose,
  chooseAlone,
  dragDuration,
  dragEvent,
  dragMarks,
  isAtEnd,
  keysInBox,
  moveSelected,
  scaleSelected,
  timeAt,
} from './timeDrags';
import { HEADER, RULER, type TimelineView } from './TimelineView';

/** Distance (CSS pixels) below which a press is a click. */
const SLOP = 3;

/**
 * Pointer input on the timeline's canvas: scrubbing, selecting, dragging keys, events and handles, box selection,
 * panning and zooming.
 */
export class TimelinePointer {
  private readonly timeline: Timeline;
  /** Positions of fingers that are down, by pointer id. */
  private readonly fingers = new Map<number, { x: number; y: number }>();
  private current: { end(keeps: boolean): void } | null = null;

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
    this.current = { end };
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
    if (y < RULER) return isAtEnd(view, x, reach) ? dragDuration(view) : this.scrub(x, event);
    if (y < HEADER) {
      const bar = selectionBar(view);
      const marks = marksOfTracks(timeline.data.tracks);
      const mark = markNear(marks, view.time(x), reach / view.scale);
      /** Horizontal distance from the pointer to a position (CSS pixels). */
      const far = (at: number): number => Math.abs(x - at);
      const toMark = mark < 0 ? Infinity : far(view.x(marks.times[mark]));
      if (bar && far(bar.x1 + GRIP) <= Math.min(reach, toMark)) return scaleSelected(view, true, x);
      if (bar && far(bar.x0 - GRIP) <= Math.min(reach, toMark)) return scaleSelected(view, false, x);
      const drag = dragMarks(view, marks, x, reach, event);
      if (drag) return drag;
      if (bar && x > bar.x0 && x < bar.x1) return moveSelected(view, view.time(x), x);
      return this.boxOrPan(x, y, event);
    }
    if (view.mode === 'curves') {
      const handle = nearestHandle(view, x, y, reach);
      if (handle) return dragHandle(view, handle);
      const key = nearestCurveKey(view, x, y, reach + 1);
      if (!key) return this.boxOrPan(x, y, event);
      choose(timeline, [key.id], event);
      const drag = dragCurveKey(view, key, { x, y });
      return { ...drag, click: () => chooseAlone(timeline, [key.id], event) };
    }
    const row = view.rows[view.rowAt(y)];
    if (row?.kind === 'events') return dragEvent(view, x, reach, event) ?? this.boxOrPan(x, y, event);
    const marks = row && marksOfRow(row);
    return (marks && dragMarks(view, marks, x, reach, event)) ?? this.boxOrPan(x, y, event);
  }

  private scrub(x: number, event: PointerEvent): SheetDrag {
    this.timeline.pause();
    this.timeline.setTime(timeAt(this.view, x, event));
    return {
      move: (to, _, moved) => this.timeline.setTime(timeAt(this.view, to, moved)),
      end: () => {},
    };
  }

  /** A press on empty space: a mouse draws a selection box, a finger pans. */
  private boxOrPan(x: number, y: number, event: PointerEvent): SheetDrag {
    const { timeline, view } = this;
    const adds = addsToSelection(event);
    const click = (): void => {
      if (!adds) timeline.select(new Set());
      if (view.chosen.size > 0 && view.mode === 'keys') view.set('chosen', new Set());
    };
    if (event.pointerType === 'touch') return { ...this.pan(x, y), click };
    const before = adds ? timeline.selection.keys : new Set<string>();
    return {
      move: (x1, y1) => {
        view.box = { x0: x, y0: y, x1, y1 };
        const inside =
          view.mode === 'curves' && y >= HEADER ? keysInCurveBox(view, view.box) : keysInBox(view, view.box);
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

  /** Pans and zooms by two fingers. */
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
    const time = timeAt(this.view, x, event);
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
