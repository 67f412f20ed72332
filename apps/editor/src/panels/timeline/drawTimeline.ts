import type { TimelineColours } from './colours';
import { drawCurves } from './drawCurves';
import { firstMark, isMarkSelected, type KeyMarks, marksOfTrack, marksOfTracks } from './keyMarks';
import { marksBetween, rulerSteps } from './rulerSteps';
import { rangeOfKeys } from '../../model/timeline/editKeys';
import type { TimelineRow } from './timelineRows';
import { HEADER, RULER, SUMMARY, type TimelineView } from './TimelineView';

/** Half of the width of a key (CSS pixels). */
export const KEY = 5;

/** Distance of the selection bar's ends, which scale the keys, from the first and last selected key (CSS pixels). */
export const GRIP = 9;

type Context = CanvasRenderingContext2D;

/** The marks of a row; null for one without keys or with another kind of marks. */
export function marksOfRow(row: TimelineRow): KeyMarks | null {
  if (row.kind === 'group') return marksOfTracks(row.tracks);
  if (row.kind === 'track') return marksOfTrack(row.track);
  return row.kind === 'channel' ? marksOfTrack(row.row.track) : null;
}

function diamond(context: Context, x: number, y: number, size: number): void {
  context.moveTo(x, y - size);
  context.lineTo(x + size, y);
  context.lineTo(x, y + size);
  context.lineTo(x - size, y);
  context.closePath();
}

/** Draws the marks of a row, selected ones on top. */
function drawMarks(
  context: Context,
  view: TimelineView,
  colours: TimelineColours,
  marks: KeyMarks,
  y: number,
  fill: string,
): void {
  const selected = view.timeline.selection.keys;
  const { times, ids } = marks;
  const last = view.time(view.width + KEY);
  let lastX = -Infinity;
  const chosen: number[] = [];
  context.beginPath();
  for (let i = firstMark(marks, view.time(-KEY)); i < times.length && times[i] <= last; i++) {
    const x = view.x(times[i]);
    if (selected.size > 0 && isMarkSelected(ids[i], selected)) chosen.push(x);
    // marks that overlap completely are drawn once
    else if (x - lastX >= 0.75) {
      diamond(context, x, y, KEY);
      lastX = x;
    }
  }
  context.fillStyle = fill;
  context.fill();
  if (chosen.length === 0) return;
  context.beginPath();
  for (const x of chosen) diamond(context, x, y, KEY + 1);
  context.fillStyle = colours.accent;
  context.fill();
  context.strokeStyle = colours.text;
  context.lineWidth = 1;
  context.stroke();
}

function drawRowGround(
  context: Context,
  view: TimelineView,
  colours: TimelineColours,
  row: TimelineRow,
  top: number,
): void {
  const { width, rowHeight } = view;
  if (row.kind === 'group' || row.kind === 'events') {
    context.fillStyle = colours.strip;
    context.fillRect(0, top, width, rowHeight);
  }
  if (view.chosen.has(row.id)) {
    context.fillStyle = colours.hover;
    context.fillRect(0, top, width, rowHeight);
  }
  context.fillStyle = colours.line;
  context.fillRect(0, top + rowHeight - 1, width, 1);
}

function drawRow(context: Context, view: TimelineView, colours: TimelineColours, row: TimelineRow, top: number): void {
  const y = top + view.rowHeight / 2;
  if (row.kind === 'events') {
    drawEvents(context, view, colours, y);
    return;
  }
  const marks = marksOfRow(row);
  if (!marks || marks.times.length === 0) return;
  const isGone = row.kind === 'track' && row.problem !== null;
  const x0 = view.x(marks.times[0]);
  context.fillStyle = isGone ? colours.error : colours.lineStrong;
  context.fillRect(x0, y - 1, view.x(marks.times.at(-1)!) - x0, 2);
  drawMarks(
    context,
    view,
    colours,
    marks,
    y,
    isGone ? colours.error : row.kind === 'track' ? colours.text : colours.dim,
  );
}

/** Draws events as flags on poles. */
function drawEvents(context: Context, view: TimelineView, colours: TimelineColours, y: number): void {
  const { data, selection } = view.timeline;
  context.font = '10px system-ui, sans-serif';
  let textEnd = -Infinity;
  data.events.forEach(({ time, method }, i) => {
    const x = view.x(time);
    if (x < -200 || x > view.width) return;
    const isSelected = selection.events.includes(i);
    context.fillStyle = isSelected ? colours.accent : colours.text;
    context.fillRect(x - 0.75, y - 7, 1.5, 14);
    context.beginPath();
    context.moveTo(x, y - 7);
    context.lineTo(x + 8, y - 3.5);
    context.lineTo(x, y);
    context.fill();
    if (x + 10 < textEnd && !isSelected) return;
    context.fillStyle = isSelected ? colours.accent : colours.dim;
    context.fillText(method, x + 10, y + 4);
    textEnd = x + 14 + context.measureText(method).width;
  });
}

/** The bar over the selected keys, whose ends scale them; null when all keys have the same time. */
export function selectionBar(view: TimelineView): { readonly x0: number; readonly x1: number } | null {
  const { data, selection } = view.timeline;
  if (selection.keys.size < 2) return null;
  const range = rangeOfKeys(data, selection.keys);
  if (!range || range.last - range.first < 1e-4) return null;
  return { x0: view.x(range.first), x1: view.x(range.last) };
}

function drawHeader(context: Context, view: TimelineView, colours: TimelineColours): void {
  const { timeline, width } = view;
  context.fillStyle = colours.strip;
  context.fillRect(0, 0, width, HEADER);
  const bar = selectionBar(view);
  if (bar) {
    const [top, tall] = [RULER + 3, SUMMARY - 7];
    context.fillStyle = colours.selected;
    context.fillRect(bar.x0, top, bar.x1 - bar.x0, tall);
    context.fillStyle = colours.accent;
    context.fillRect(bar.x0 - GRIP - 1.5, top, 3, tall);
    context.fillRect(bar.x1 + GRIP - 1.5, top, 3, tall);
  }
  drawMarks(context, view, colours, marksOfTracks(timeline.data.tracks), RULER + SUMMARY / 2, colours.dim);
  context.fillStyle = colours.lineStrong;
  context.fillRect(0, HEADER - 1, width, 1);
  const { step, perLabel, labelOf } = rulerSteps(view.scale, timeline.frameRate, view.unit);
  context.font = '10px system-ui, sans-serif';
  for (const i of marksBetween(Math.max(view.time(-40), 0), view.time(width), step)) {
    const x = Math.round(view.x(i * step)) + 0.5;
    const hasLabel = i % perLabel === 0;
    context.fillStyle = hasLabel ? colours.dim : colours.lineStrong;
    context.fillRect(x - 0.5, hasLabel ? RULER - 7 : RULER - 4, 1, hasLabel ? 7 : 4);
    if (hasLabel) context.fillText(labelOf(i * step), x + 3, RULER - 8);
  }
  context.fillStyle = colours.line;
  context.fillRect(0, RULER, width, 1);
}

/** Draws the vertical lines of the ruler across the rows. */
function drawGround(context: Context, view: TimelineView, colours: TimelineColours): void {
  const { timeline, width, height } = view;
  context.fillStyle = colours.panel;
  context.fillRect(0, 0, width, height);
  const { step, perLabel } = rulerSteps(view.scale, timeline.frameRate, view.unit);
  context.fillStyle = colours.line;
  for (const i of marksBetween(Math.max(view.time(0), 0), view.time(width), step)) {
    if (i % perLabel === 0) context.fillRect(Math.round(view.x(i * step)), HEADER, 1, height - HEADER);
  }
}

/** Darkens the area before the beginning and after the end of the clip. */
function drawOutside(context: Context, view: TimelineView, colours: TimelineColours): void {
  const { width, height, timeline } = view;
  const end = view.x(timeline.duration);
  const zero = view.x(0);
  context.globalAlpha = 0.45;
  context.fillStyle = colours.strip;
  if (end < width) context.fillRect(end, HEADER, width - end, height - HEADER);
  if (zero > 0) context.fillRect(0, HEADER, zero, height - HEADER);
  context.globalAlpha = 1;
  context.fillStyle = colours.lineStrong;
  context.fillRect(Math.round(end), HEADER, 1, height - HEADER);
}

function drawEnd(context: Context, view: TimelineView, colours: TimelineColours): void {
  const end = view.x(view.timeline.duration);
  // draws the handle that changes the clip's duration
  context.beginPath();
  context.moveTo(end - 1, 2);
  context.lineTo(end + 6, 2);
  context.lineTo(end + 6, RULER - 3);
  context.lineTo(end - 1, RULER - 3);
  context.fillStyle = colours.dim;
  context.fill();
}

function drawPlayhead(context: Context, view: TimelineView, colours: TimelineColours): void {
  const { timeline, height } = view;
  const x = view.x(timeline.time);
  if (x < -8 || x > view.width + 8) return;
  context.fillStyle = timeline.isRecording ? colours.error : colours.accent;
  context.fillRect(x - 0.75, RULER - 4, 1.5, height);
  context.beginPath();
  context.moveTo(x - 6, 2);
  context.lineTo(x + 6, 2);
  context.lineTo(x + 6, RULER - 9);
  context.lineTo(x, RULER - 2);
  context.lineTo(x - 6, RULER - 9);
  context.fill();
}

/** Draws ruler, keys or curves, and the playhead; only the visible part. */
export function drawTimeline(canvas: HTMLCanvasElement, view: TimelineView, colours: TimelineColours): void {
  const context = canvas.getContext('2d')!;
  const ratio = devicePixelRatio;
  const { width, height, box } = view;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  drawGround(context, view, colours);
  context.save();
  context.beginPath();
  context.rect(0, HEADER, width, height - HEADER);
  context.clip();
  if (view.mode === 'curves') {
    drawOutside(context, view, colours);
    drawCurves(context, view, colours);
  } else {
    const first = Math.max(Math.floor(view.scrollTop / view.rowHeight), 0);
    const end = Math.min(Math.ceil((view.scrollTop + height - HEADER) / view.rowHeight), view.rows.length);
    for (let i = first; i < end; i++) drawRowGround(context, view, colours, view.rows[i], view.rowTop(i));
    drawOutside(context, view, colours);
    for (let i = first; i < end; i++) drawRow(context, view, colours, view.rows[i], view.rowTop(i));
  }
  context.restore();
  drawHeader(context, view, colours);
  drawEnd(context, view, colours);
  drawPlayhead(context, view, colours);
  if (!box) return;
  context.strokeStyle = colours.accent;
  context.fillStyle = colours.accent;
  const [x, y] = [Math.min(box.x0, box.x1), Math.min(box.y0, box.y1)];
  const [wide, tall] = [Math.abs(box.x1 - box.x0), Math.abs(box.y1 - box.y0)];
  context.globalAlpha = 0.15;
  context.fillRect(x, y, wide, tall);
  context.globalAlpha = 1;
  context.lineWidth = 1;
  context.strokeRect(x + 0.5, y + 0.5, wide, tall);
}
