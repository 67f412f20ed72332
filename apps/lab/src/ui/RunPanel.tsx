import { useEffect, useRef, useState } from 'preact/hooks';
import { competitorLabel, valueText } from '../words/names';
import { PixelCanvas } from './PixelCanvas';
import { formatDuration } from './support/formatDuration';
import type { Running } from './support/useRun';

/** How often a screen reader hears of the progress (ms). */
const TOLD = 15_000;

/** What is measured now, how long it takes yet, and the button that ends it. */
export function RunPanel({ running, onCancel }: { running: Running; onCancel(): void }) {
  const { done, total, remaining, competitor, series, labCase, plan, isCancelled } = running;
  const part = Math.min(1, done / total);
  const percent = Math.floor(part * 100);
  const index = series.cases.indexOf(labCase);
  const value = valueText(series.axis, series.values[index]);
  const left = remaining === null ? 'working out how long' : `about ${formatDuration(remaining)} left`;
  const told = useTold(`${percent}% measured, ${left}.`);
  const isHidden = useHidden();
  const title = useRef<HTMLHeadingElement>(null);
  // the button that began the run is disabled now, and on a phone far above
  useEffect(() => {
    title.current?.focus({ preventScroll: true });
    title.current?.closest('section')?.scrollIntoView({ block: 'nearest' });
  }, []);
  return (
    <section class="running" aria-labelledby="running-title">
      <PixelCanvas pixels={running.picture} label="Last picture" class="live" width={160} height={90} />
      <div class="running-words">
        <h2 id="running-title" ref={title} tabIndex={-1}>
          Measuring: {plan.label} <span class="dim">{isCancelled ? 'ending …' : left}</span>
        </h2>
        <progress value={part} max={1} aria-labelledby="running-title" />
        <p class="now">
          <strong>{competitor === null ? 'Comparing pictures' : competitorLabel(competitor)}</strong>
          <span>
            {series.label}: {value}
          </span>
          <span class="dim">
            {labCase.width} × {labCase.height}
          </span>
        </p>
        {isHidden && (
          <p class="warning" role="alert">
            The tab is hidden, so the run waits: browsers slow down what nobody sees.
          </p>
        )}
        <p class="dim">Keep this tab in front, and let the machine do nothing else.</p>
      </div>
      <button type="button" class="cancel" onClick={onCancel} disabled={isCancelled}>
        Cancel
        <span class="visually-hidden"> and keep what was measured</span>
      </button>
      <p class="visually-hidden" role="status">
        {told}
      </p>
    </section>
  );
}

/** Text that changes seldom, so that a screen reader does not talk all the time. */
function useTold(text: string): string {
  const [told, setTold] = useState(text);
  const now = useRef(text);
  now.current = text;
  useEffect(() => {
    const timer = setInterval(() => setTold(now.current), TOLD);
    return () => clearInterval(timer);
  }, []);
  return told;
}

function useHidden(): boolean {
  const [isHidden, setHidden] = useState(document.hidden);
  useEffect(() => {
    const look = (): void => setHidden(document.hidden);
    document.addEventListener('visibilitychange', look);
    return () => document.removeEventListener('visibilitychange', look);
  }, []);
  return isHidden;
}
