import { type FieldValue, isTriple } from '@farol/editing/fields';
import type { ClipData, ClipKey, ClipTrack } from './ClipData';

/** Rounds a number to nine digits, which distinguish all single-precision numbers. */
function short(value: number): number {
  // skips the conversion to text for numbers that cannot have more digits
  const size = Math.abs(value);
  const unit = size < 1 ? 1e9 : size < 1000 ? 1e6 : 1;
  if (size < 1e9 && Math.round(value * unit) / unit === value) return value + 0;
  return Number(value.toPrecision(9)) + 0;
}

const shortValue = (value: FieldValue): FieldValue => {
  if (typeof value === 'number') return short(value);
  return isTriple(value) ? [short(value[0]), short(value[1]), short(value[2])] : value;
};

/**
 * Text of a clip, as a ClipAsset stores it. Numbers are rounded to nine digits, so that reading and writing it again
 * gives the same text; keys are sorted by time, and the last of equal times is kept.
 */
export function clipText({ tracks, events }: ClipData): string {
  return JSON.stringify({
    tracks: tracks.map(({ path, component, field, keys }) => ({ path, component, field, keys: sortedKeys(keys) })),
    events: events
      .map(({ time, method, value }) => ({
        time: short(time),
        method,
        ...(value === undefined ? {} : { value: shortValue(value) }),
      }))
      .toSorted((a, b) => a.time - b.time),
  });
}

function sortedKeys(keys: ClipTrack['keys']): ClipKey[] {
  const byTime = new Map<number, ClipKey>();
  for (const { time, value, easing, control } of keys) {
    byTime.set(short(time), {
      time: short(time),
      value: shortValue(value),
      ...(easing === undefined || easing === 'linear' ? {} : { easing }),
      ...(easing === 'bezier' && control
        ? { control: [short(control[0]), short(control[1]), short(control[2]), short(control[3])] as const }
        : {}),
    });
  }
  return [...byTime.values()].toSorted((a, b) => a.time - b.time);
}
