import type { Field, FieldValue } from '@farol/editing/fields';
import type { ClipTrack } from '../assets/clips/ClipData';
import { curveOf } from './TrackCurve';

const numbers = new Float64Array(3);

/**
 * Value of a track at a time; before the first key that of the first key, after the last key that of the last.
 * @param field - animated field, whose range limits interpolated values
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
