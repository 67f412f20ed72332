import type { Configuration, SeriesChoice } from '../../plan/Configuration';
import type { LabPlan, LabSeries } from '../../plan/LabPlan';
import { planOf } from '../../plan/planOf';
import { presets } from '../../plan/presets';

/**
 * Configuration from which a plan was made, to measure a run again or link to it.
 *
 * @returns null if no configuration leads to the plan, as for a run of another version
 */
export function configurationOfPlan(plan: LabPlan): Configuration | null {
  const size = sizeOf(plan);
  if (!size || plan.series.some(({ cases }) => cases.length === 0)) return null;
  const configuration: Configuration = {
    preset: Object.hasOwn(presets, plan.preset) ? plan.preset : 'custom',
    series: plan.series.map(choiceOf),
    ...size,
    competitors: plan.competitors,
    effort: plan.effort,
  };
  try {
    return casesText(planOf(configuration)) === casesText(plan) ? configuration : null;
  } catch {
    return null;
  }
}

const casesText = ({ series }: LabPlan): string => JSON.stringify(series.map(({ axis, cases }) => [axis, cases]));

/** Size of the picture: that of a series not along pixels, otherwise of the largest case: its aspect is most exact. */
function sizeOf({ series }: LabPlan): { width: number; height: number } | null {
  const fixed = series.find(({ axis }) => axis !== 'pixels') ?? series[0];
  const last = fixed?.cases[fixed.cases.length - 1];
  return last ? { width: last.width, height: last.height } : null;
}

function choiceOf({ axis, cases, values }: LabSeries): SeriesChoice {
  const [first] = cases;
  const along = axis === 'pixels' ? values.map((pixels) => Math.round(pixels / 1000)) : values;
  const byObjects = axis === 'objects' && cases.every(({ lights }, index) => lights === values[index]);
  return {
    scene: first.scene.name,
    n: axis === 'objects' ? 1 : Number(first.scene.parameters.n ?? 1),
    axis,
    values: along,
    lights: axis === 'lights' ? 0 : byObjects ? 'objects' : (first.lights ?? 0),
    ...(axis !== 'kind' && first.lightKind !== 'points' && { lightKind: first.lightKind }),
    ...(first.lightRange !== null && { lightRange: first.lightRange }),
    ...(axis !== 'shading' && first.shading !== 'own' && { shading: first.shading }),
  };
}
