import { t } from '@farol/editing';
import { useEffect, useRef } from 'preact/hooks';
import { RunCharts } from '../../charts/RunCharts';
import { Comparison } from '../../results/Comparison';
import type { LabRun } from '../../results/LabRun';

/** Comparison of two runs: tables side by side, and curves in common charts. */
export function ComparedRuns({ runs, onClose }: { runs: readonly [LabRun, LabRun]; onClose(): void }) {
  const place = useRef<HTMLDivElement>(null);
  useEffect(() => place.current?.focus(), [runs]);
  return (
    <div ref={place} class="results compared" tabIndex={-1}>
      <button type="button" class="quiet close" onClick={onClose}>
        {t('Close the comparison')}
      </button>
      <Comparison a={runs[0]} b={runs[1]} />
      <RunCharts runs={runs} />
    </div>
  );
}
