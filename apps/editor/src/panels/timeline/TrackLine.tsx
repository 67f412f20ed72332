import { formatNumber, t, toDegrees } from '@farol/editing';
import { type Field, type FieldValue, isTriple } from '@farol/engine/fields';
import type { MouseEvent, ReactNode } from 'react';
import { valueAt } from '../../model/timeline/clipTracks';
import { addEventAt, addKeys, hasKeyAt } from '../../model/timeline/timelineEdits';
import { useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { IconButton } from '../../ui/IconButton';
import { LostTracks } from './LostTracks';
import type { TimelineRow, TrackRow } from './timelineRows';
import type { TimelineView } from './TimelineView';

interface TrackLineProps {
  readonly view: TimelineView;
  readonly row: TimelineRow;
  readonly index: number;
  /** Whether the row can be reached by Tab. */
  readonly isCurrent: boolean;
  readonly isChosen: boolean;
  onFold(isOpen: boolean): void;
  onRemove(): void;
}

const LEVELS = { events: 1, group: 1, track: 2, channel: 3 } as const;

function valueText(value: FieldValue, field: Field | null, channel: number | null): string {
  const isAngle = field?.kind === 'angle' || field?.kind === 'euler';
  const text = (number: number): string => formatNumber(isAngle ? toDegrees(number) : number, 'short');
  if (typeof value === 'number') return text(value);
  if (isTriple(value)) return channel === null ? value.map((each) => text(each)).join('  ') : text(value[channel]);
  return typeof value === 'boolean' ? (value ? t('On ## a flag') : t('Off ## a flag')) : String(value);
}

/** Value of a track at the playhead, with a field to edit it. */
function CurrentValue({
  view,
  row,
  channel,
}: {
  view: TimelineView;
  row: TrackRow;
  channel: number | null;
}): ReactNode {
  const { timeline } = view;
  useSignal(timeline.moved);
  const { keys } = row.track;
  if (keys.length === 0) return null;
  return <span className="track-value one-line">{valueText(valueAt(keys, timeline.time), row.field, channel)}</span>;
}

function KeyButton({ view, row }: { view: TimelineView; row: TrackRow }): ReactNode {
  const { timeline } = view;
  useSignal(timeline.moved);
  const isThere = hasKeyAt(row.track, timeline.time);
  const label = t('Add a key to {field}', { field: row.label });
  return (
    <IconButton
      icon="key"
      className="track-key"
      data-on={isThere}
      tabIndex={-1}
      label={label}
      onClick={() => addKeys(timeline, [row.track])}
    />
  );
}

/** A row of the timeline's list: name, value at the playhead, and buttons. */
export function TrackLine(props: TrackLineProps): ReactNode {
  const { view, row, index, isCurrent, isChosen, onFold, onRemove } = props;
  const isOpen = row.kind === 'group' || row.kind === 'track' ? row.isOpen : null;
  const problem = row.kind === 'track' ? row.problem : null;
  const track = row.kind === 'track' ? row : row.kind === 'channel' ? row.row : null;
  const click = (event: MouseEvent): void => {
    if ((event.target as Element).closest('button')) return;
    if (event.ctrlKey || event.metaKey || event.shiftKey) view.toggle('chosen', row.id);
    else view.set('chosen', new Set([row.id]));
  };
  return (
    <div
      className={`track-line track-${row.kind}`}
      role="row"
      aria-level={LEVELS[row.kind]}
      aria-rowindex={index + 1}
      aria-expanded={isOpen ?? undefined}
      aria-selected={isChosen}
      data-problem={problem !== null}
      tabIndex={isCurrent ? 0 : -1}
      style={{ top: index * view.rowHeight, height: view.rowHeight }}
      title={problem ?? undefined}
      onClick={click}
    >
      <span className="track-name" role="gridcell">
        {isOpen !== null && (
          <button
            type="button"
            className="fold"
            data-open={isOpen}
            tabIndex={-1}
            aria-label={isOpen ? t('Fold {name}', { name: row.label }) : t('Unfold {name}', { name: row.label })}
            onClick={() => onFold(!isOpen)}
          >
            <Icon name="chevron" size={11} />
          </button>
        )}
        {row.kind === 'channel' && <span className={`axis axis-${'xyz'[row.channel]}`}>{row.label}</span>}
        <span className="track-label one-line">{row.kind === 'channel' ? '' : row.label}</span>
        {problem && <span className="track-problem one-line">{problem}</span>}
      </span>
      <span className="track-tools" role="gridcell">
        {track && !problem && (
          <CurrentValue view={view} row={track} channel={row.kind === 'channel' ? row.channel : null} />
        )}
        {row.kind === 'group' && row.isLost && <LostTracks view={view} row={row} />}
        {row.kind === 'track' && !problem && <KeyButton view={view} row={row} />}
        {row.kind === 'events' && (
          <IconButton
            icon="add"
            className="track-key"
            tabIndex={-1}
            label={t('Add an event')}
            onClick={() => addEventAt(view.timeline, view.timeline.time)}
          />
        )}
        {(row.kind === 'track' || row.kind === 'group') && (
          <IconButton
            icon="close"
            className="track-key track-remove"
            tabIndex={-1}
            label={t('Remove {name}', { name: row.label })}
            onClick={onRemove}
          />
        )}
      </span>
    </div>
  );
}
