import { t, tCount } from '@farol/editing';
import { watchPixelRatio } from '@farol/engine';
import { type KeyboardEvent, type ReactNode, type RefObject, useEffect, useId, useRef } from 'react';
import { useSignal } from '../../ui/EditorContext';
import { readColours } from './colours';
import { drawTimeline } from './drawTimeline';
import { timeText } from './rulerSteps';
import { TimelinePointer } from './TimelinePointer';
import { RULER, type TimelineView } from './TimelineView';

interface TimelineSheetProps {
  readonly view: TimelineView;
  /** Height of the sheet (CSS pixels). */
  readonly height: number;
  readonly scroller: RefObject<HTMLDivElement | null>;
}

/** Canvas with ruler, keys and curves, and focusable elements on top. */
export function TimelineSheet({ view, height, scroller }: TimelineSheetProps): ReactNode {
  const sheet = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const probe = useRef<HTMLElement>(null);
  const helpId = useId();
  useDrawing(view, sheet, canvas, probe);
  useEffect(() => {
    const end = new AbortController();
    const pointer = new TimelinePointer(view, sheet.current!, (by) => {
      scroller.current!.scrollTop += by;
    });
    pointer.listen(end.signal);
    return () => end.abort();
  }, [view, scroller]);
  return (
    <div
      className="timeline-sheet"
      ref={sheet}
      style={{ height }}
      onPointerDown={(event) => {
        const { top } = event.currentTarget.getBoundingClientRect();
        const inRuler = event.clientY - top < RULER;
        event.currentTarget
          .querySelector<HTMLElement>(inRuler ? '.timeline-playhead' : '.timeline-keys')
          ?.focus({ preventScroll: true });
      }}
    >
      <canvas ref={canvas} aria-hidden="true" />
      <i ref={probe} hidden />
      <Playhead view={view} />
      <div
        className="timeline-keys"
        role="application"
        tabIndex={0}
        aria-label={view.mode === 'curves' ? t('Curves') : t('Dope sheet')}
        aria-describedby={helpId}
      />
      <p id={helpId} className="hidden-text">
        {t(
          'Arrow keys move the playhead, with Ctrl from key to key, with Alt the selected keys. Enter selects the keys at the playhead.',
        )}
      </p>
      <SelectionText view={view} />
    </div>
  );
}

/** Draws at most once per animation frame, when something has changed. */
function useDrawing(
  view: TimelineView,
  sheet: RefObject<HTMLDivElement | null>,
  canvas: RefObject<HTMLCanvasElement | null>,
  probe: RefObject<HTMLElement | null>,
): void {
  useEffect(() => {
    const { timeline } = view;
    let frame = 0;
    const draw = (): void => {
      frame = 0;
      if (view.width > 0 && view.height > 0) drawTimeline(canvas.current!, view, readColours(probe.current!));
    };
    const ask = (): void => {
      frame ||= requestAnimationFrame(draw);
    };
    const observer = new ResizeObserver(() => view.resize(sheet.current!.clientWidth, sheet.current!.clientHeight));
    observer.observe(sheet.current!);
    const themes = new MutationObserver(ask);
    themes.observe(document.documentElement, { attributeFilter: ['data-theme'] });
    const media = matchMedia('(prefers-color-scheme: dark)');
    media.addEventListener('change', ask);
    const endings = [view.drawAsked, timeline.changed, timeline.moved].map((signal) => signal.subscribe(ask));
    endings.push(watchPixelRatio(ask));
    ask();
    return () => {
      cancelAnimationFrame(frame);
      observer.disconnect();
      themes.disconnect();
      media.removeEventListener('change', ask);
      for (const end of endings) end();
    };
    // oxlint-disable-next-line react/exhaustive-effect-dependencies -- refs never change
  }, [view, sheet, canvas, probe]);
}

/** The playhead as a slider, for keyboard and screen readers. */
function Playhead({ view }: { view: TimelineView }): ReactNode {
  const { timeline } = view;
  useSignal(timeline.moved);
  const { time, duration, frameRate } = timeline;
  const frame = Math.round(time * frameRate);
  const keyDown = (event: KeyboardEvent): void => {
    if (event.key !== 'ArrowUp' && event.key !== 'ArrowDown') return;
    event.preventDefault();
    timeline.pause();
    timeline.stepFrames(event.key === 'ArrowUp' ? 1 : -1);
  };
  return (
    <div
      className="timeline-playhead"
      role="slider"
      tabIndex={0}
      style={{ height: RULER }}
      aria-label={t('Playhead')}
      aria-valuemin={0}
      aria-valuemax={Math.max(duration, time)}
      aria-valuenow={Math.round(time * 1000) / 1000}
      aria-valuetext={t('{time} s, frame {frame}', { time: timeText(time, frameRate, 'seconds'), frame })}
      onKeyDown={keyDown}
    />
  );
}

/** Announces the selection to screen readers. */
function SelectionText({ view }: { view: TimelineView }): ReactNode {
  const { timeline } = view;
  useSignal(timeline.changed);
  const { keys, events } = timeline.selection;
  return (
    <p className="hidden-text" role="status">
      {keys.size > 0 && tCount(keys.size, '{count} key selected', '{count} keys selected')}
      {events.length > 0 && tCount(events.length, '{count} event selected', '{count} events selected')}
    </p>
  );
}
