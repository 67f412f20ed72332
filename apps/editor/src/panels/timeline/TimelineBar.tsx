import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { clipName } from '../../model/timeline/clipEdits';
import { addKeys } from '../../model/timeline/timelineEdits';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { IconButton, type IconButtonProps } from '../../ui/IconButton';
import { MenuButton } from '../../ui/MenuButton';
import { clipEntries } from './clipEntries';
import { easingEntries } from './easingEntries';
import { nextKeyTime } from './keyMarks';
import { SelectedFields } from './SelectedFields';
import type { TimelineView } from './TimelineView';
import { tracksForKeys } from './tracksForKeys';

/** A tool of the bar: an icon, and its key in the tooltip. */
const Tool = ({ keys, ...props }: IconButtonProps & { readonly keys?: string }): ReactNode => (
  <IconButton size={16} className="button" title={keys ? `${props.label} (${keys})` : props.label} {...props} />
);

/** Toolbar of the timeline: recording, playback, the clip, and fields of the selected keys. */
export function TimelineBar({ view }: { view: TimelineView }): ReactNode {
  const { timeline } = view;
  const editor = useEditor();
  useSignal(timeline.changed);
  useSignal(editor.document.assetsChanged);
  const { clip, data, isPlaying, isRecording, canRecord, selection } = timeline;
  const goTo = (time: number | null): void => {
    if (time === null) return;
    timeline.pause();
    timeline.setTime(time);
    view.reveal(time);
  };
  const clips = (
    <MenuButton
      label={clip ? clipName(clip) : t('Clips')}
      icon="timeline"
      className="button timeline-clip"
      entries={() => clipEntries(editor, timeline)}
    />
  );
  if (!clip) return <div className="panel-bar">{clips}</div>;
  return (
    <div className="panel-bar timeline-bar" role="toolbar" aria-label={t('Timeline tools')}>
      <Tool
        label={t('Record')}
        icon="record"
        keys="Shift+K"
        className="button record"
        aria-pressed={isRecording}
        disabled={!canRecord}
        onClick={() => timeline.setRecording(!isRecording)}
      />
      <span className="bar-line" />
      <Tool label={t('To the beginning')} icon="first" keys="Home" onClick={() => goTo(0)} />
      <Tool
        label={t('Previous key')}
        icon="previousKey"
        keys="Ctrl+←"
        onClick={() => goTo(nextKeyTime(data, timeline.time, -1))}
      />
      <Tool
        label={isPlaying ? t('Pause the clip') : t('Play the clip')}
        icon={isPlaying ? 'pause' : 'play'}
        aria-pressed={isPlaying}
        disabled={!canRecord}
        onClick={() => (isPlaying ? timeline.pause() : timeline.play())}
      />
      <Tool
        label={t('Next key')}
        icon="nextKey"
        keys="Ctrl+→"
        onClick={() => goTo(nextKeyTime(data, timeline.time, 1))}
      />
      <Tool label={t('To the end')} icon="last" keys="End" onClick={() => goTo(timeline.duration)} />
      <span className="bar-line" />
      {clips}
      <Tool
        label={t('Add keys')}
        icon="key"
        disabled={data.tracks.length === 0}
        onClick={() => addKeys(timeline, tracksForKeys(view))}
      />
      <div className="button-group" role="group" aria-label={t('What is shown')}>
        <Tool
          label={t('Dope sheet')}
          icon="timeline"
          aria-pressed={view.mode === 'keys'}
          onClick={() => view.set('mode', 'keys')}
        />
        <Tool
          label={t('Curves')}
          icon="curve"
          aria-pressed={view.mode === 'curves'}
          onClick={() => view.set('mode', 'curves')}
        />
      </div>
      <MenuButton label={t('Easing')} disabled={selection.keys.size === 0} entries={() => easingEntries(timeline)} />
      <SelectedFields view={view} />
    </div>
  );
}
