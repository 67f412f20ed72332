import { t, tCount } from '@farol/editing';
import { usesOwnScene } from '../../own/ownPreset';
import type { Configuration } from '../../plan/Configuration';
import type { LabPlan } from '../../plan/LabPlan';
import { estimate, planOf } from '../../plan/planOf';
import { roughDuration } from './formatDuration';
import { messageOf } from '../../run/messageOf';

/** A plan, or the reason, a sentence, why a configuration is invalid. */
export type Planned = { plan: LabPlan; problem: null } | { plan: null; problem: string };

/** Makes the plan of a configuration. @param hasOwnScene - whether a scene was handed over */
export function planned(configuration: Configuration, hasOwnScene: boolean): Planned {
  if (usesOwnScene(configuration) && !hasOwnScene) {
    const problem = t(
      'The scene that was handed over is not here: choose “Measure this scene” in the editor or the viewer, or another scene.',
    );
    return { plan: null, problem };
  }
  try {
    return { plan: planOf(configuration), problem: null };
  } catch (error) {
    return { plan: null, problem: messageOf(error) };
  }
}

/** Size of a plan: `12 cases × 13 competitors, about 1 min 20 s`. */
export function planSize(plan: LabPlan): string {
  const cases = plan.series.reduce((sum, { cases }) => sum + cases.length, 0);
  const time = roughDuration(estimate(plan));
  return t('{cases} × {competitors}, about {time}', {
    cases: tCount(cases, '{count} case', '{count} cases'),
    competitors: tCount(plan.competitors.length, '{count} competitor', '{count} competitors'),
    time,
  });
}
