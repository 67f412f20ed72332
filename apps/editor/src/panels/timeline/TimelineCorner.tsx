import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { setDuration } from '../../model/timeline/clipEdits';
import { addTrack } from '../../model/timeline/timelineEdits';
import { animatableFields } from '../../model/timeline/trackTargets';
import { findTrack, trackId } from '../../model/timeline/clipTracks';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { NumberInput } from '../../ui/NumberInput';
import { SearchMenu, type SearchMenuItem } from '../../ui/SearchMenu';
import { RULER, SUMMARY, type TimelineView } from './TimelineView';
import { Button } from '../../ui/Button';

/** Corner beside the ruler: time of the playhead, duration of the clip, and a button for new tracks. */
export function TimelineCorner({ view }: { view: TimelineView }): ReactNode {
  const { timeline, unit } = view;
  const editor = useEditor();
  useSignal(timeline.moved);
  const isFrames = unit === 'frames';
  const rate = isFrames ? timeline.frameRate : 1;
  const step = isFrames ? 1 : 1 / timeline.frameRate;
  const { clip, root } = timeline;
  let duration = timeline.duration;
  const fields = (): SearchMenuItem[] =>
    root
      ? animatableFields(root)
          .filter(({ address }) => !findTrack(timeline.data, address))
          .map(({ address, object, component, field }) => ({
            value: trackId(address),
            label: field,
            help: t('{object}: {component}', { object, component }),
          }))
      : [];
  const add = (id: string): void => {
    const found = root && animatableFields(root).find(({ address }) => trackId(address) === id);
    if (found) editor.attempt(() => addTrack(timeline, found));
  };
  return (
    <div className="timeline-corner">
      <div className="timeline-times" style={{ height: RULER }}>
        <NumberInput
          value={timeline.time * rate}
          min={0}
          step={step}
          digits="short"
          label={isFrames ? t('Frame') : t('Time in seconds')}
          onPreview={(shown) => timeline.setTime(shown / rate)}
        />
        <span aria-hidden="true">/</span>
        <NumberInput
          value={duration * rate}
          min={0}
          step={step}
          digits="short"
          label={isFrames ? t('Frames of the clip') : t('Duration in seconds')}
          onPreview={(shown) => {
            duration = shown / rate;
          }}
          onCommit={() => clip && duration !== timeline.duration && editor.commands.run(setDuration(clip, duration))}
        />
        <Button
          look="small"
          label={isFrames ? t('frames ## of a clip') : t('s ## seconds')}
          aria-label={isFrames ? t('Show seconds') : t('Show frames')}
          title={isFrames ? t('Show seconds') : t('Show frames')}
          onClick={() => view.set('unit', isFrames ? 'seconds' : 'frames')}
        />
      </div>
      <div className="timeline-add" style={{ height: SUMMARY }}>
        {root ? (
          <SearchMenu label={t('Add track')} icon="add" className="button small" items={fields} onChoose={add} />
        ) : (
          <span className="timeline-note one-line">{t('No object plays this clip.')}</span>
        )}
      </div>
    </div>
  );
}
