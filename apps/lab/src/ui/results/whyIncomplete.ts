import type { LabRun } from '../../results/LabRun';

/** Why a run has not every figure of its plan, as a sentence; null for a complete one. */
export function whyIncomplete({ complete, duration, plan, rows }: LabRun): string | null {
  if (complete) return null;
  const { limit } = plan.effort;
  const isOver = rows.some(({ problem }) => problem?.startsWith('Not measured')) || duration >= (limit ?? Infinity);
  return isOver
    ? 'The time for the run was over before every case was measured: give it more under “How thoroughly”, or measure less.'
    : 'This run was cancelled: what was measured until then is kept and shown.';
}
