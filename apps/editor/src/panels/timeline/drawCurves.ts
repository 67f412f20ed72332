import { formatNumber } from '@farol/editing';
import type { ClipKey } from '@farol/engine';
import { keyId } from '../../model/timeline/clipTracks';
import { STRAIGHT } from '../../model/timeline/easingCurve';
import type { TimelineColours } from './colours';
import { firstMark, marksOfTrack } from './keyMarks';
import { marksBetween } from './rulerSteps';
import { type ShownCurve, shownCurves } from './shownCurves';
import { HEADER, type TimelineView } from './TimelineView';

type Context = CanvasRenderingContext2D;

/** A handle of the Bézier curve from key `index` to the next one. */
export interface CurveHandle {
  readonly curve: ShownCurve;
  readonly index: number;
  /** End of the segment that the handle belongs to: 0 for key `index`, 1 for the next key. */
  readonly end: 0 | 1;
  readonly x: number;
  readonly y: number;
}

const point = (view: TimelineView, curve: ShownCurve, key: ClipKey): [number, number] => [
  view.x(key.time),
  view.y(curve.shownOf(key)),
];

/** Canvas positions of the inner control points between two keys. */
function controlPoints(view: TimelineView, curve: ShownCurve, from: ClipKey, to: ClipKey): [number, number][] {
  const [x1, y1, x2, y2] = from.control ?? STRAIGHT;
  const [xa, ya] = point(view, curve, from);
  const [xb, yb] = point(view, curve, to);
  return [
    [xa + (xb - xa) * x1, ya + (yb - ya) * y1],
    [xa + (xb - xa) * x2, ya + (yb - ya) * y2],
  ];
}

/** Tangent handles that are visible: those of selected keys. */
export function curveHandles(view: TimelineView): CurveHandle[] {
  const { keys: selected } = view.timeline.selection;
  const handles: CurveHandle[] = [];
  if (selected.size === 0) return handles;
  for (const curve of shownCurves(view)) {
    const { keys } = curve.row.track;
    keys.forEach((key, index) => {
      const next = keys[index + 1];
      if (key.easing !== 'bezier' || !next) return;
      const ends = [key, next].map(({ time }) => selected.has(keyId(curve.row.id, time)));
      if (!ends[0] && !ends[1]) return;
      const points = controlPoints(view, curve, key, next);
      for (const end of [0, 1] as const)
        if (ends[end]) handles.push({ curve, index, end, x: points[end][0], y: points[end][1] });
    });
  }
  return handles;
}

const colourOf = (curve: ShownCurve, colours: TimelineColours): string =>
  curve.row.problem ? colours.error : curve.isTriple ? colours.channels[curve.channel] : colours.text;

function drawCurve(context: Context, view: TimelineView, colours: TimelineColours, curve: ShownCurve): void {
  const { keys } = curve.row.track;
  const marks = marksOfTrack(curve.row.track);
  const first = Math.max(firstMark(marks, view.time(0)) - 1, 0);
  const last = view.time(view.width);
  context.beginPath();
  const [startX, startY] = point(view, curve, keys[first]);
  context.moveTo(first === 0 ? 0 : startX, startY);
  context.lineTo(startX, startY);
  let end = first;
  for (; end + 1 < keys.length && keys[end].time <= last; end++) {
    const [from, to] = [keys[end], keys[end + 1]];
    const [x, y] = point(view, curve, to);
    if (from.easing === 'step') {
      context.lineTo(x, view.y(curve.shownOf(from)));
      context.lineTo(x, y);
    } else if (from.easing === 'bezier') {
      const [[xa, ya], [xb, yb]] = controlPoints(view, curve, from, to);
      context.bezierCurveTo(xa, ya, xb, yb, x, y);
    } else context.lineTo(x, y);
  }
  if (end === keys.length - 1) context.lineTo(view.width, view.y(curve.shownOf(keys[end])));
  context.strokeStyle = colourOf(curve, colours);
  context.lineWidth = 1.5;
  context.stroke();
}

function drawKeys(context: Context, view: TimelineView, colours: TimelineColours, curve: ShownCurve): void {
  const { keys: selected } = view.timeline.selection;
  const { keys } = curve.row.track;
  const marks = marksOfTrack(curve.row.track);
  const last = view.time(view.width + 6);
  for (let i = firstMark(marks, view.time(-6)); i < keys.length && keys[i].time <= last; i++) {
    const [x, y] = point(view, curve, keys[i]);
    const isSelected = selected.has(marks.ids[i][0]);
    context.beginPath();
    context.arc(x, y, isSelected ? 5 : 3.5, 0, 2 * Math.PI);
    context.fillStyle = isSelected ? colours.accent : colourOf(curve, colours);
    context.fill();
    context.strokeStyle = isSelected ? colours.text : colours.panel;
    context.lineWidth = 1;
    context.stroke();
  }
}

function drawValues(context: Context, view: TimelineView, colours: TimelineColours): void {
  const leastStep = 32 / view.valueScale;
  const power = 10 ** Math.floor(Math.log10(leastStep));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((each) => each >= leastStep)!;
  context.font = '10px system-ui, sans-serif';
  for (const i of marksBetween(view.value(view.height), view.value(HEADER), step)) {
    const y = Math.round(view.y(i * step));
    context.fillStyle = i === 0 ? colours.lineStrong : colours.line;
    context.fillRect(0, y, view.width, 1);
    context.fillStyle = colours.dim;
    context.fillText(formatNumber(i * step, 'short'), 2, y - 2);
  }
}

/** Draws the curves of the chosen rows, their keys, and the handles of selected keys. */
export function drawCurves(context: Context, view: TimelineView, colours: TimelineColours): void {
  drawValues(context, view, colours);
  const curves = shownCurves(view);
  for (const curve of curves) drawCurve(context, view, colours, curve);
  for (const curve of curves) drawKeys(context, view, colours, curve);
  for (const { curve, index, end, x, y } of curveHandles(view)) {
    const [keyX, keyY] = point(view, curve, curve.row.track.keys[index + end]);
    context.strokeStyle = colours.accent;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(keyX, keyY);
    context.lineTo(x, y);
    context.stroke();
    context.beginPath();
    context.rect(x - 3.5, y - 3.5, 7, 7);
    context.fillStyle = colours.panel;
    context.fill();
    context.stroke();
  }
}
