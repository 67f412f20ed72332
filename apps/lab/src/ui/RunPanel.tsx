import { t } from '@farol/editing';
import { useEffect, useRef, useState } from 'preact/hooks';
import { competitorLabel, valueText } from '../words/names';
import { seriesLabel } from '../words/seriesLabel';
import { PixelCanvas } from './PixelCanvas';
import { formatDuration } from './support/formatDuration';
import type { Running } from './support/useRun';

/** Interval between announcements of the progress for screen readers (ms). */
const ANNOUNCED = 15_000;

/** Progress of a run, the time left, and the button that cancels it. */
export function RunPanel({ running, onCancel }: { running: Running; onCancel(): void }) {
  const { done, total, remaining, competitor, series, labCase, plan, isCancelled } = running;
  const part = Math.min(1, done / total);
  const percent = Math.floor(part * 100);
  const index = series.cases.indexOf(labCase);
  const value = valueText(series.axis, series.values[index]);
  const left =
    remaining === null ? t('working out how long') : t('about {time} left', { time: formatDuration(remaining) });
  const announced = useAnnounced(t('{percent}% measured, {left}.', { percent, left }));
  const isHidden = useHidden();
  const title = useRef<HTMLHeadingElement>(null);
  // moves the focus: the start button lost it by being disabled, and is far above on a phone
  useEffect(() => {
    title.current?.focus({ preventScroll: true });
    title.current?.closest('section')?.scrollIntoView({ block: 'nearest' });
  }, []);
  return (
    <section class="running" aria-labelledby="running-title">
      <PixelCanvas pixels={running.picture} label={t('Last picture')} class="live" width={160} height={90} />
      <div class="running-words">
        <h2 id="running-title" ref={title} tabIndex={-1}>
          {t('Measuring: {label}', { label: t(plan.label) })}{' '}
          <span class="dim">{isCancelled ? t('ending …') : left}</span>
        </h2>
        <progress value={part} max={1} aria-labelledby="running-title" />
        <p class="now">
          <strong>{competitor === null ? t('Comparing pictures') : competitorLabel(competitor)}</strong>
          <span>
            {seriesLabel(series)}: {value}
          </span>
          <span class="dim">
            {labCase.width} × {labCase.height}
          </span>
        </p>
        {isHidden && (
          <p class="warning" role="alert">
            {t('The tab is hidden, so the run waits: browsers throttle hidden tabs.')}
          </p>
        )}
        <p class="dim">{t('Keep this tab in front, and let the machine do nothing else.')}</p>
      </div>
      <button type="button" class="cancel" onClick={onCancel} disabled={isCancelled}>
        {t('Cancel')}
        <span class="visually-hidden"> {t('and keep what was measured')}</span>
      </button>
      <p class="visually-hidden" role="status">
        {announced}
      </p>
    </section>
  );
}

/** A text that changes at most every 15 s, so that a screen reader is not constantly speaking. */
function useAnnounced(text: string): string {
  const [announced, setAnnounced] = useState(text);
  const now = useRef(text);
  now.current = text;
  useEffect(() => {
    const timer = setInterval(() => setAnnounced(now.current), ANNOUNCED);
    return () => clearInterval(timer);
  }, []);
  return announced;
}

function useHidden(): boolean {
  const [isHidden, setHidden] = useState(document.hidden);
  useEffect(() => {
    const update = (): void => setHidden(document.hidden);
    document.addEventListener('visibilitychange', update);
    return () => document.removeEventListener('visibilitychange', update);
  }, []);
  return isHidden;
}
