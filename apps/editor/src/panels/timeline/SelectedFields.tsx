import { describeField, sharedValue, t } from '@farol/editing';
import type { Field, FieldValue } from '@farol/engine/fields';
import { type ComponentType, type ReactNode, useMemo } from 'react';
import type { FieldEditorProps } from '../../api/FieldEditorProps';
import { fieldEditors } from '../../fields';
import { selectedKeys } from '../../model/timeline/editKeys';
import type { Timeline } from '../../model/timeline/Timeline';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { NumberInput } from '../../ui/NumberInput';
import { EventFields } from './EventFields';
import { KeyGesture } from './KeyGesture';
import type { TrackRow } from './timelineRows';
import type { TimelineView } from './TimelineView';

/** Time and value of the selected keys or events. */
export function SelectedFields({ view }: { view: TimelineView }): ReactNode {
  const { timeline } = view;
  useSignal(timeline.changed);
  const { data, selection } = timeline;
  const keys = useMemo(() => selectedKeys(data, selection.keys), [data, selection]);
  if (keys.length === 0) return <EventFields view={view} />;
  return (
    <div className="timeline-fields" role="group" aria-label={t('Selected keys')}>
      <TimeField view={view} times={keys.map(({ key }) => key.time)} />
      <ValueField view={view} />
    </div>
  );
}

const useGesture = (timeline: Timeline): KeyGesture => {
  const { commands } = useEditor();
  return useMemo(() => new KeyGesture(timeline, commands), [timeline, commands]);
};

function TimeField({ view, times }: { view: TimelineView; times: readonly number[] }): ReactNode {
  const { timeline, unit } = view;
  const gesture = useGesture(timeline);
  const isFrames = unit === 'frames';
  const rate = isFrames ? timeline.frameRate : 1;
  const isOne = times.every((time) => time === times[0]);
  return (
    <div className="timeline-time">
      <NumberInput
        value={isOne ? times[0] * rate : null}
        min={0}
        step={isFrames ? 1 : 1 / timeline.frameRate}
        unit={isFrames ? undefined : 's'}
        digits="short"
        label={t('Time of the key')}
        handle={<span className="grip" />}
        onPreview={(shown) => gesture.previewTimes(() => shown / rate)}
        onPreviewEach={(update) => gesture.previewTimes((time) => update(time * rate) / rate)}
        onCommit={() => gesture.commit()}
        onDiscard={() => gesture.discard()}
      />
    </div>
  );
}

/** The field of the selected keys, when all of them animate similar fields; else null. */
function fieldOf(view: TimelineView): { field: Field; row: TrackRow } | null {
  const { data, selection } = view.timeline;
  const tracks = new Set(selectedKeys(data, selection.keys).map(({ track }) => track));
  const rows = view.rows.filter((row): row is TrackRow => row.kind === 'track' && tracks.has(row.track));
  const [first] = rows;
  if (rows.length < tracks.size || !first?.field) return null;
  const { field } = first;
  const unitOf = (each: Field): unknown => ('unit' in each ? each.unit : '');
  const isLike = rows.every(
    (row) =>
      row.field === field ||
      (row.field?.kind === field.kind && field.kind !== 'choice' && unitOf(row.field) === unitOf(field)),
  );
  return isLike ? { field, row: first } : null;
}

function ValueField({ view }: { view: TimelineView }): ReactNode {
  const { timeline } = view;
  const editor = useEditor();
  const gesture = useGesture(timeline);
  const found = fieldOf(view);
  if (!found) return null;
  const { field, row } = found;
  const values = selectedKeys(timeline.data, timeline.selection.keys).map(({ key }) => key.value);
  const { value, mixed, parts } = sharedValue(values);
  const Editor = fieldEditors[field.kind] as ComponentType<FieldEditorProps<Field>>;
  return (
    <div className={`timeline-value field-${field.kind}`}>
      <Editor
        field={field}
        name={row.track.field}
        value={value as never}
        mixed={mixed}
        parts={parts}
        label={row.label}
        description={describeField(field)}
        disabled={false}
        onPreview={(update) => editor.attempt(() => gesture.previewValues(update as FieldValue))}
        onCommit={(update) => editor.attempt(() => gesture.commit(update as FieldValue | undefined))}
        onAmend={(update) => editor.attempt(() => gesture.amend(update as FieldValue))}
        onDiscard={() => gesture.discard()}
      />
    </div>
  );
}
