import { t } from '@farol/editing';
import { type KeyboardEvent, type ReactNode, useEffect, useState } from 'react';
import { timelineOf } from '../../model/timeline/timelineOf';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { EmptyTimeline } from './EmptyTimeline';
import { handleTimelineKey } from './handleTimelineKey';
import './timeline.css';
import { TimelineBar } from './TimelineBar';
import { TimelineBody } from './TimelineBody';
import { timelineRows } from './timelineRows';
import { TimelineView } from './TimelineView';

/** Editor of clips: keys over time, curves and events. */
export function TimelinePanel(): ReactNode {
  const editor = useEditor();
  const timeline = timelineOf(editor);
  const [view] = useState(() => new TimelineView(timeline));
  useEffect(() => {
    timeline.open();
    return () => timeline.close();
  }, [timeline]);
  usePlaying(view);
  useSignal(timeline.changed);
  useSignal(editor.document.structure);
  useSignal(view.changed);
  const { clip, root, data } = timeline;
  const { folded, unfolded, mode } = view;
  view.rows = timelineRows(root, data, { folded, unfolded, hasChannels: mode === 'curves' });
  useEffect(() => {
    if (clip) view.fit();
  }, [view, clip]);
  useEffect(() => view.draw());
  const keyDown = (event: KeyboardEvent): void => {
    if (!handleTimelineKey(editor, view, event)) return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <section className="panel timeline" aria-label={t('Timeline')} onKeyDown={keyDown}>
      <TimelineBar view={view} />
      {clip ? <TimelineBody view={view} /> : <EmptyTimeline timeline={timeline} />}
    </section>
  );
}

/** Moves the playhead each frame while the clip or the scene plays. */
function usePlaying(view: TimelineView): void {
  const { timeline } = view;
  const { document } = useEditor();
  useSignal(document.simulation.changed);
  const plays = timeline.isPlaying || document.simulation.isPlaying;
  useEffect(() => {
    if (!plays) return;
    let last = performance.now();
    let frame = requestAnimationFrame(function next(now) {
      timeline.advance(Math.min((now - last) / 1000, 0.1));
      last = now;
      frame = requestAnimationFrame(next);
    });
    return () => cancelAnimationFrame(frame);
  }, [timeline, plays]);
}
