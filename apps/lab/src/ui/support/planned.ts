import type { Configuration } from '../../plan/Configuration';
import type { LabPlan } from '../../plan/LabPlan';
import { estimate, planOf } from '../../plan/planOf';
import { roughDuration } from './formatDuration';

/** A plan, or why a configuration makes none, as a sentence. */
export type Planned = { plan: LabPlan; problem: null } | { plan: null; problem: string };

/** Makes the plan of a configuration. */
export function planned(configuration: Configuration): Planned {
  try {
    return { plan: planOf(configuration), problem: null };
  } catch (error) {
    return { plan: null, problem: error instanceof Error ? error.message : String(error) };
  }
}

/** How much a plan is: `12 cases × 13 competitors, about 1 min 20 s`. */
export function planSize(plan: LabPlan): string {
  const cases = plan.series.reduce((sum, { cases }) => sum + cases.length, 0);
  const count = (n: number, one: string): string => `${n} ${one}${n === 1 ? '' : 's'}`;
  const time = roughDuration(estimate(plan));
  return `${count(cases, 'case')} × ${count(plan.competitors.length, 'competitor')}, about ${time}`;
}
