import { numberDisplay } from '@farol/editing';
import type { ClipKey } from '@farol/engine';
import { isTriple } from '@farol/engine/fields';
import { isNumeric } from '../../model/timeline/clipTracks';
import type { TimelineRow, TrackRow } from './timelineRows';
import type { TimelineView } from './TimelineView';

/** A curve of the curve view: one coordinate of a track. */
export interface ShownCurve {
  readonly row: TrackRow;
  /** Index of the coordinate; 0 for a number. */
  readonly channel: 0 | 1 | 2;
  readonly isTriple: boolean;
  /** The value of a key as displayed, angles in degrees. */
  shownOf(key: ClipKey): number;
  /** Converts a displayed value to the field's unit. */
  fromShown(shown: number): number;
}

const same = (value: number): number => value;

/** Conversion to displayed units. Values of fields whose target no longer exists are not converted. */
const displayOf = ({ field }: TrackRow): { toShown(value: number): number; fromShown(shown: number): number } =>
  field && field.kind !== 'colour' && field.kind !== 'boolean' && field.kind !== 'choice'
    ? numberDisplay(field)
    : { toShown: same, fromShown: same };

const known = new WeakMap<readonly TimelineRow[], { chosen: ReadonlySet<string>; curves: readonly ShownCurve[] }>();

/** The curves of the chosen rows, or of all when none is chosen. */
export function shownCurves(view: TimelineView): readonly ShownCurve[] {
  const last = known.get(view.rows);
  if (last?.chosen === view.chosen) return last.curves;
  const { chosen, rows } = view;
  const isShown = (row: TrackRow, channel: number): boolean => {
    const { path, component } = row.track;
    const group = `${path}\n${component}`;
    return chosen.has(row.id) || chosen.has(`${row.id}\n${channel}`) || chosen.has(group);
  };
  const all = curvesOf(rows);
  const some = all.filter(({ row, channel }) => isShown(row, channel));
  const curves = some.length > 0 ? some : all;
  known.set(rows, { chosen, curves });
  return curves;
}

function curvesOf(rows: readonly TimelineRow[]): ShownCurve[] {
  return rows.flatMap((row): ShownCurve[] => {
    if (row.kind !== 'track' || !isNumeric(row.track.keys[0]?.value)) return [];
    const { toShown, fromShown } = displayOf(row);
    if (!isTriple(row.track.keys[0].value)) {
      return [{ row, channel: 0, isTriple: false, fromShown, shownOf: ({ value }) => toShown(value as number) }];
    }
    return ([0, 1, 2] as const).map((channel) => ({
      row,
      channel,
      isTriple: true,
      fromShown,
      shownOf: ({ value }) => toShown((value as readonly number[])[channel]),
    }));
  });
}

/** Smallest and largest displayed value of keys in a time range; null when there are none. */
export function valuesOfCurves(view: TimelineView, first = -Infinity, last = Infinity): [number, number] | null {
  let [low, high] = [Infinity, -Infinity];
  for (const curve of shownCurves(view)) {
    for (const key of curve.row.track.keys) {
      if (key.time < first || key.time > last) continue;
      const value = curve.shownOf(key);
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
  }
  return low > high ? null : [low, high];
}
