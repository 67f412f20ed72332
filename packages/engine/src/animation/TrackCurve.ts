import { checkFieldValue, type Field, type FieldValue } from '@farol/editing/fields';
import type { ClipTrack } from '../assets/clips/ClipData';
import { cubicBezier } from './cubicBezier';

const LINEAR = 0;
const STEP = 1;
const BEZIER = 2;

/** Number of components of a field's values; 0 for a field without interpolation. */
export function sizeOfField(field: Field): 0 | 1 | 3 {
  if (field.kind === 'number' || field.kind === 'angle') return 1;
  return field.kind === 'vector3' || field.kind === 'euler' || field.kind === 'colour' ? 3 : 0;
}

/** A track as arrays of numbers, for one kind of field. Any number of objects may read it. */
export class TrackCurve {
  /** Numbers per value; 0 for values that change in steps, without interpolation. */
  readonly size: 0 | 1 | 3;
  readonly count: number;
  /** Times of the keys (s). */
  readonly times: Float64Array;
  /** Values of the keys, one after another: `count` × `size` numbers. */
  readonly values: Float64Array;
  /** Values of the keys of a field that changes in steps. */
  readonly steps: readonly FieldValue[];
  private readonly easings: Uint8Array;
  private readonly controls: Float64Array | null;
  private readonly min: number;
  private readonly max: number;
  private readonly isInteger: boolean;

  constructor(track: ClipTrack, field: Field) {
    const { keys } = track;
    this.size = sizeOfField(field);
    this.count = keys.length;
    this.times = Float64Array.from(keys, ({ time }) => time);
    this.steps = this.size === 0 ? keys.map(({ value }) => value) : [];
    const numbers = this.size === 0 ? [] : keys.flatMap(({ value }) => value as number | number[]);
    this.values = Float64Array.from(numbers);
    this.easings = Uint8Array.from(keys, ({ easing }) =>
      easing === 'step' ? STEP : easing === 'bezier' ? BEZIER : LINEAR,
    );
    this.controls = keys.some(({ control }) => control)
      ? Float64Array.from(keys.flatMap(({ control }) => control ?? [1 / 3, 1 / 3, 2 / 3, 2 / 3]))
      : null;
    const { min, max } = field as { min?: number; max?: number };
    this.min = field.kind === 'colour' ? 0 : (min ?? -Infinity);
    this.max = max ?? Infinity;
    this.isInteger = field.kind === 'number' && field.integer === true;
  }

  /**
   * Index of the last key at or before a time; -1 before the first key.
   * @param near - index of the last call, where the search begins
   */
  indexAt(time: number, near = 0): number {
    const { times, count } = this;
    if (near >= 0 && near < count && times[near] <= time) {
      if (near + 1 >= count || time < times[near + 1]) return near;
      if (near + 2 >= count || time < times[near + 2]) return near + 1;
    }
    let low = 0;
    let high = count;
    while (low < high) {
      const middle = (low + high) >>> 1;
      if (times[middle] <= time) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }

  /** Writes the numbers of the value at a time to `target`, from `offset` on. @param index - `indexAt(time)` */
  evaluate(time: number, index: number, target: Float64Array, offset = 0): void {
    const { size, count, values } = this;
    const from = Math.max(index, 0);
    const share = this.shareAt(time, index);
    const a = from * size;
    const b = share === 0 || from + 1 >= count ? a : a + size;
    for (let i = 0; i < size; i++) {
      const value = values[a + i] + (values[b + i] - values[a + i]) * share;
      target[offset + i] = share === 1 ? values[b + i] : this.allowed(value);
    }
  }

  /** The value of a field that changes in steps. @param index - `indexAt(time)` */
  stepAt(index: number): FieldValue {
    return this.steps[Math.max(index, 0)];
  }

  /** Share of the change to the next key: 0 to 1, or beyond for an overshooting curve. */
  private shareAt(time: number, index: number): number {
    const { times, count, easings, controls } = this;
    if (index < 0 || index + 1 >= count || easings[index] === STEP) return 0;
    const x = (time - times[index]) / (times[index + 1] - times[index]);
    if (easings[index] === LINEAR || !controls) return x;
    const i = index * 4;
    return cubicBezier(controls[i], controls[i + 1], controls[i + 2], controls[i + 3], x);
  }

  private allowed(value: number): number {
    const inside = value < this.min ? this.min : value > this.max ? this.max : value;
    return this.isInteger ? Math.round(inside) : inside;
  }
}

/** Reason why a track cannot be played on a field, as "key 3: must be …"; null when it can. Cached per track. */
export function problemWithTrack(track: ClipTrack, field: Field): string | null {
  const known = checked.get(track);
  if (known?.field === field) return known.problem;
  const problem = findProblem(track, field);
  checked.set(track, { field, problem });
  return problem;
}

const checked = new WeakMap<ClipTrack, { readonly field: Field; readonly problem: string | null }>();

function findProblem({ keys }: ClipTrack, field: Field): string | null {
  for (const [i, { value }] of keys.entries()) {
    const problem = checkFieldValue(field, value);
    if (problem) return `key ${i + 1} ${problem}`;
  }
  return null;
}

interface Made {
  readonly field: Field;
  readonly curve: TrackCurve;
}

const made = new WeakMap<ClipTrack, Made>();

/** The curve of a track for a field, cached. Check with `problemWithTrack` first that the track can be played. */
export function curveOf(track: ClipTrack, field: Field): TrackCurve {
  const known = made.get(track);
  if (known?.field === field) return known.curve;
  const curve = new TrackCurve(track, field);
  made.set(track, { field, curve });
  return curve;
}
