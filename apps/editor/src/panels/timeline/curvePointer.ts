import { t } from '@farol/editing';
import type { ClipTrack } from '@farol/engine';
import { isTriple } from '@farol/engine/fields';
import { keyId, valueAt } from '../../model/timeline/clipTracks';
import { STRAIGHT } from '../../model/timeline/easingCurve';
import { easeKeys, type KeySelection, moveKeys, setValuesOfKeys } from '../../model/timeline/editKeys';
import { movedLabel } from '../../model/timeline/timelineEdits';
import { type CurveHandle, curveHandles } from './drawCurves';
import { type ShownCurve, shownCurves } from './shownCurves';
import { editDrag, type SheetDrag } from './SheetDrag';
import type { Box, TimelineView } from './TimelineView';

export interface CurveKey {
  readonly curve: ShownCurve;
  readonly index: number;
  readonly id: string;
}

/** The handle closest to a position, within a reach (CSS pixels). */
export function nearestHandle(view: TimelineView, x: number, y: number, reach: number): CurveHandle | null {
  let nearest: CurveHandle | null = null;
  let least = reach;
  for (const handle of curveHandles(view)) {
    const distance = Math.hypot(handle.x - x, handle.y - y);
    if (distance <= least) [nearest, least] = [handle, distance];
  }
  return nearest;
}

/** Calls `visit` with each key of the shown curves and its position on the canvas. */
function eachKey(view: TimelineView, visit: (key: CurveKey, x: number, y: number) => void): void {
  for (const curve of shownCurves(view)) {
    curve.row.track.keys.forEach((key, index) => {
      visit({ curve, index, id: keyId(curve.row.id, key.time) }, view.x(key.time), view.y(curve.shownOf(key)));
    });
  }
}

/** The key of a curve closest to a position, within a reach (CSS pixels). */
export function nearestCurveKey(view: TimelineView, x: number, y: number, reach: number): CurveKey | null {
  let nearest: CurveKey | null = null;
  let least = reach;
  eachKey(view, (key, keyX, keyY) => {
    const distance = Math.hypot(keyX - x, keyY - y);
    if (distance <= least) [nearest, least] = [key, distance];
  });
  return nearest;
}

/** The keys whose points are within a box. */
export function keysInCurveBox(view: TimelineView, { x0, y0, x1, y1 }: Box): string[] {
  const ids: string[] = [];
  eachKey(view, ({ id }, x, y) => {
    if (x < Math.min(x0, x1) || x > Math.max(x0, x1) || y < Math.min(y0, y1) || y > Math.max(y0, y1)) return;
    ids.push(id);
  });
  return ids;
}

/** The track of the curve closest to a position; null when none is near. */
export function trackOfCurveAt(view: TimelineView, x: number, y: number): ClipTrack | null {
  let nearest: ClipTrack | null = null;
  let least = 14;
  for (const curve of shownCurves(view)) {
    const { track } = curve.row;
    const value = valueAt(track.keys, view.time(x));
    const distance = Math.abs(view.y(curve.shownOf({ time: 0, value })) - y);
    if (distance < least) [nearest, least] = [track, distance];
  }
  return nearest;
}

/** Replaces one coordinate of a key's value. */
const withNumber =
  (curve: ShownCurve, change: (shown: number) => number) => (before: ClipTrack['keys'][0]['value']) => {
    const next = curve.fromShown(change(curve.shownOf({ time: 0, value: before })));
    if (!isTriple(before)) return next;
    return [0, 1, 2].map((i) => (i === curve.channel ? next : before[i])) as unknown as typeof before;
  };

/** Clamps a number to the limits of its field. */
function limited({ row, fromShown }: ShownCurve, shown: number, toShown: (value: number) => number): number {
  const { min = -Infinity, max = Infinity } = (row.field ?? {}) as { min?: number; max?: number };
  const lowest = row.field?.kind === 'colour' ? 0 : min;
  const value = fromShown(shown);
  if (value < lowest) return toShown(lowest);
  return value > max ? toShown(max) : shown;
}

/** Drags the selected keys in time, and those of the dragged curve in value. Shift restricts to one direction. */
export function dragCurveKey(
  view: TimelineView,
  { curve, index }: CurveKey,
  from: { x: number; y: number },
): SheetDrag {
  const { timeline } = view;
  const { keys: selected } = timeline.selection;
  const anchor = curve.row.track.keys[index].time;
  return editDrag(timeline, (gesture, x, y, event) => {
    let [wide, tall] = [x - from.x, y - from.y];
    if (event.shiftKey && Math.abs(wide) > Math.abs(tall)) tall = 0;
    else if (event.shiftKey) wide = 0;
    const time = anchor + wide / view.scale;
    const by = wide === 0 ? 0 : (event.altKey ? time : timeline.snap(time)) - anchor;
    const rise = -tall / view.valueScale;
    const ofTrack: KeySelection = new Set(
      curve.row.track.keys.map((key) => keyId(curve.row.id, key.time)).filter((id) => selected.has(id)),
    );
    const toShown = (value: number): number =>
      curve.shownOf({ time: 0, value: curve.isTriple ? [value, value, value] : value });
    const raised =
      tall === 0
        ? gesture.data
        : setValuesOfKeys(
            gesture.data,
            ofTrack,
            withNumber(curve, (shown) => limited(curve, roundRise(shown + rise, view), toShown)),
          );
    gesture.preview(movedLabel(timeline, selected.size), moveKeys(raised, selected, by));
  });
}

/** Rounds a value to the digits that a pixel can resolve. */
function roundRise(value: number, { valueScale }: TimelineView): number {
  const digits = Math.min(Math.max(Math.ceil(Math.log10(valueScale)), 0), 10);
  return Number(value.toFixed(digits));
}

/** Drags a tangent handle of a Bézier curve. */
export function dragHandle(view: TimelineView, { curve, index, end }: CurveHandle): SheetDrag {
  const { timeline } = view;
  const { track } = curve.row;
  const [from, to] = [track.keys[index], track.keys[index + 1]];
  const before = from.control ?? STRAIGHT;
  const ids: KeySelection = new Set([keyId(curve.row.id, from.time)]);
  const label = t('Eased {field} of {name}', {
    field: curve.row.label.toLowerCase(),
    name: timeline.clip?.name ?? '',
  });
  return editDrag(timeline, (gesture, x, y) => {
    const share = Math.min(Math.max((view.time(x) - from.time) / (to.time - from.time), 0), 1);
    const [low, high] = [curve.shownOf(from), curve.shownOf(to)];
    const way = Math.abs(high - low) < 1e-9 ? before[end * 2 + 1] : (view.value(y) - low) / (high - low);
    const control =
      end === 0 ? ([share, way, before[2], before[3]] as const) : ([before[0], before[1], share, way] as const);
    gesture.preview(label, easeKeys(gesture.data, ids, 'bezier', control));
  });
}
