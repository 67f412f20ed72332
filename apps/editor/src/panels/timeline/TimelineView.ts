import { Signal } from '@farol/editing';
import type { Timeline } from '../../model/timeline/Timeline';
import type { TimelineRow } from './timelineRows';

const isCoarse = matchMedia('(pointer: coarse)').matches;

/** Height of the ruler, and of the row of all keys below it (CSS pixels); larger for fingers. */
export const RULER = isCoarse ? 40 : 24;
export const SUMMARY = isCoarse ? 40 : 24;
export const HEADER = RULER + SUMMARY;

/** Padding left of time 0, so that a key there is fully visible (CSS pixels). */
const PAD = 14;

const [SMALLEST, LARGEST] = [2, 20_000];

/** Selection box (CSS pixels of the canvas). */
export interface Box {
  readonly x0: number;
  readonly y0: number;
  readonly x1: number;
  readonly y1: number;
}

/** View state of the timeline: scales, scrolling, folded rows. Not part of the document. */
export class TimelineView {
  /** Emits when rows, or settings shown in the toolbar, change. */
  readonly changed = new Signal();
  /** Emits when the canvas must be redrawn. */
  readonly drawAsked = new Signal();

  mode: 'keys' | 'curves' = 'keys';
  unit: 'seconds' | 'frames' = 'seconds';
  folded: ReadonlySet<string> = new Set();
  unfolded: ReadonlySet<string> = new Set();
  /** Ids of the chosen rows; the curve view shows only their curves, if any. */
  chosen: ReadonlySet<string> = new Set();
  rows: readonly TimelineRow[] = [];
  readonly rowHeight = isCoarse ? 40 : 24;

  /** Size of the canvas (CSS pixels). */
  width = 0;
  height = 0;
  scrollTop = 0;
  /** Time at the left edge (s); `scale` is the CSS pixels per second. */
  start = 0;
  scale = 200;
  /** Value at the centre of the curve view; `valueScale` is the CSS pixels per unit of the value. */
  middleValue = 0;
  valueScale = 40;
  box: Box | null = null;

  private hasFitted = false;

  constructor(readonly timeline: Timeline) {}

  readonly draw = (): void => this.drawAsked.emit();

  set<K extends 'mode' | 'unit' | 'folded' | 'unfolded' | 'chosen'>(name: K, value: TimelineView[K]): void {
    if (this[name] === value) return;
    Object.assign(this, { [name]: value });
    this.changed.emit();
    this.draw();
  }

  toggle(name: 'folded' | 'unfolded' | 'chosen', id: string): void {
    const next = new Set(this[name]);
    if (!next.delete(id)) next.add(id);
    this.set(name, next);
  }

  x(time: number): number {
    return PAD + (time - this.start) * this.scale;
  }

  time(x: number): number {
    return this.start + (x - PAD) / this.scale;
  }

  y(value: number): number {
    return HEADER + (this.height - HEADER) / 2 - (value - this.middleValue) * this.valueScale;
  }

  value(y: number): number {
    return this.middleValue + (HEADER + (this.height - HEADER) / 2 - y) / this.valueScale;
  }

  /** Top of a row on the canvas (CSS pixels). */
  rowTop(index: number): number {
    return HEADER + index * this.rowHeight - this.scrollTop;
  }

  /** Index of the row at a vertical position (CSS pixels); -1 in the header and below the last row. */
  rowAt(y: number): number {
    if (y < HEADER) return -1;
    const index = Math.floor((y - HEADER + this.scrollTop) / this.rowHeight);
    return index < this.rows.length ? index : -1;
  }

  resize(width: number, height: number): void {
    this.width = width;
    this.height = height;
    if (!this.hasFitted && width > 0) this.fit();
    this.draw();
  }

  /** Shows the whole clip. */
  fit(): void {
    const { duration } = this.timeline;
    if (this.width <= 0) return;
    this.hasFitted = true;
    this.start = 0;
    this.scale = this.limit((this.width - 2 * PAD - 16) / Math.max(duration, 0.05));
    this.draw();
  }

  /** Shows a range of times, and of values in the curve view. */
  frame(first: number, last: number, low?: number, high?: number): void {
    this.hasFitted = true;
    const span = Math.max(last - first, 0.05);
    this.scale = this.limit((this.width - 4 * PAD) / span);
    this.start = Math.max((first + last) / 2 - (this.width / 2 - PAD) / this.scale, 0);
    if (low !== undefined && high !== undefined) {
      this.middleValue = (low + high) / 2;
      this.valueScale = ((this.height - HEADER) * 0.8) / Math.max(high - low, 1e-3);
    }
    this.draw();
  }

  /** Scales the time axis about a position of the canvas (CSS pixels). */
  zoom(factor: number, x: number): void {
    const time = this.time(x);
    this.scale = this.limit(this.scale * factor);
    this.start = Math.max(time - (x - PAD) / this.scale, 0);
    this.draw();
  }

  zoomValues(factor: number, y: number): void {
    const value = this.value(y);
    this.valueScale = Math.min(Math.max(this.valueScale * factor, 1e-6), 1e7);
    this.middleValue += value - this.value(y);
    this.draw();
  }

  /** Scrolls by CSS pixels. */
  pan(x: number, y = 0): void {
    this.start = Math.max(this.start - x / this.scale, 0);
    if (this.mode === 'curves') this.middleValue += y / this.valueScale;
    this.draw();
  }

  /** Scrolls until a time is visible. */
  reveal(time: number): void {
    const x = this.x(time);
    if (x >= PAD && x <= this.width - PAD) return;
    this.start = Math.max(time - (x < PAD ? 0.1 : 0.7) * (this.width / this.scale), 0);
    this.draw();
  }

  private limit(scale: number): number {
    return Math.min(Math.max(scale, SMALLEST), LARGEST);
  }
}
