import type { Field, FieldValue } from '@farol/editing/fields';
import type { ClipTrack } from '../assets/clips/ClipData';
import { curveOf } from './TrackCurve';

const numbers = new Float64Array(3);

/**
 * The value of a track at a time: that of the first key before it, that of the last one after it.
 * @param field - what the track animates: its range holds the values between keys
 * @param time - seconds from the beginning of the clip
 * @returns undefined when the track has no keys
 */
export function valueAt(track: ClipTrack, field: Field, time: number): FieldValue | undefined {
  const curve = curveOf(track, field);
  if (curve.count === 0) return undefined;
  const index = curve.indexAt(time);
  if (curve.size === 0) return curve.stepAt(index);
  curve.evaluate(time, index, numbers);
  return curve.size === 1 ? numbers[0] : [numbers[0], numbers[1], numbers[2]];
}
