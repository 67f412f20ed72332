import { t } from '@farol/editing';
import type { LabRow, LabRun } from '../../results/LabRun';

/** Whether a run was cancelled before anything was measured; rows of competitors that cannot draw do not count. */
export function isEmptyRun({ complete, rows }: Pick<LabRun, 'complete' | 'rows'>): boolean {
  return !complete && rows.every(({ frame }) => frame === null) && !rows.some(isLate);
}

const isLate = ({ problem }: LabRow): boolean => problem?.startsWith('Not measured') ?? false;

/** Reason, a sentence, why a run lacks measurements of its plan; null for a complete run. */
export function whyIncomplete(run: LabRun): string | null {
  const { complete, duration, plan, rows } = run;
  if (complete) return null;
  if (isEmptyRun(run)) return t('This run was cancelled before anything was measured, and is not kept.');
  const { limit } = plan.effort;
  const isOver = rows.some(isLate) || duration >= (limit ?? Infinity);
  return isOver
    ? t(
        'The time for the run was over before every case was measured: give it more under “How thoroughly”, or measure less.',
      )
    : t('This run was cancelled: what was measured until then is kept and shown.');
}
