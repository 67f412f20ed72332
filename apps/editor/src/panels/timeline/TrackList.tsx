import { t } from '@farol/editing';
import { type KeyboardEvent, type ReactNode, type RefObject, useRef } from 'react';
import { addKeys, deleteTracks } from '../../model/timeline/timelineEdits';
import { useSignal } from '../../ui/EditorContext';
import { TrackLine } from './TrackLine';
import type { TimelineRow } from './timelineRows';
import { HEADER, type TimelineView } from './TimelineView';

interface TrackListProps {
  readonly view: TimelineView;
  /** Height of the visible part of the list; `scrollTop` is its scroll position (CSS pixels). */
  readonly height: number;
  readonly scrollTop: number;
  readonly scroller: RefObject<HTMLDivElement | null>;
}

/** Names of the rows; only visible ones are rendered. */
export function TrackList({ view, height, scrollTop, scroller }: TrackListProps): ReactNode {
  const { timeline, rows, rowHeight } = view;
  useSignal(timeline.changed);
  const list = useRef<HTMLDivElement>(null);
  const chosen = rows.findIndex((row) => view.chosen.has(row.id));
  const current = Math.max(chosen, 0);
  const first = Math.max(Math.floor(scrollTop / rowHeight) - 2, 0);
  const last = Math.min(first + Math.ceil(Math.max(height, 0) / rowHeight) + 5, rows.length);
  const rendered = [...rows.keys()].slice(first, last);
  // the focused row is rendered even when scrolled out of view
  if (current < first) rendered.unshift(current);
  else if (current >= last && current < rows.length) rendered.push(current);

  const goTo = (index: number): void => {
    const row = rows[Math.min(Math.max(index, 0), rows.length - 1)];
    if (!row) return;
    view.set('chosen', new Set([row.id]));
    const at = rows.indexOf(row);
    const element = scroller.current!;
    const [top, bottom] = [at * rowHeight, (at + 1) * rowHeight - (element.clientHeight - HEADER)];
    if (element.scrollTop > top) element.scrollTop = top;
    else if (element.scrollTop < bottom) element.scrollTop = bottom;
    requestAnimationFrame(() => list.current?.querySelector<HTMLElement>(`[aria-rowindex="${at + 1}"]`)?.focus());
  };
  const fold = (row: TimelineRow, isOpen: boolean): void => {
    if (row.kind === 'group' && row.isOpen !== isOpen) view.toggle('folded', row.id);
    if (row.kind === 'track' && row.isOpen !== null && row.isOpen !== isOpen) view.toggle('unfolded', row.id);
  };
  const keyDown = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const at = Number((event.target as HTMLElement).closest('[aria-rowindex]')?.getAttribute('aria-rowindex') ?? 0) - 1;
    const row = rows[at];
    if (!row) return;
    const acts: Record<string, () => void> = {
      ArrowDown: () => goTo(at + 1),
      ArrowUp: () => goTo(at - 1),
      ArrowRight: () => fold(row, true),
      ArrowLeft: () => fold(row, false),
      Home: () => goTo(0),
      End: () => goTo(rows.length - 1),
      Delete: () => remove(row),
      Enter: () => row.kind === 'track' && addKeys(timeline, [row.track]),
    };
    const act = Object.hasOwn(acts, event.key) ? acts[event.key] : null;
    if (!act || (event.key === 'Enter' && (event.target as HTMLElement).closest('button'))) return;
    event.preventDefault();
    event.stopPropagation();
    act();
  };
  const remove = (row: TimelineRow): void => {
    if (row.kind === 'track') deleteTracks(timeline, [row.track]);
    if (row.kind === 'group') deleteTracks(timeline, row.tracks);
  };
  return (
    <div
      ref={list}
      className="timeline-rows"
      role="treegrid"
      aria-label={t('Tracks')}
      aria-rowcount={rows.length}
      style={{ height: rows.length * rowHeight }}
      onKeyDown={keyDown}
    >
      {rendered.map((index) => (
        <TrackLine
          key={rows[index].id}
          view={view}
          row={rows[index]}
          index={index}
          isCurrent={index === current}
          isChosen={view.chosen.has(rows[index].id)}
          onFold={(isOpen) => fold(rows[index], isOpen)}
          onRemove={() => remove(rows[index])}
        />
      ))}
    </div>
  );
}
