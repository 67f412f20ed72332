import type { LabPlan } from '../../plan/LabPlan';
import type { LabRow } from '../../results/LabRun';

/** Most pictures of a run that are held: 240 kB each at 320 × 180. */
const MOST = 400;

/** Pictures as they were drawn, of runs of this session: a run that is kept or exported has small ones alone. */
const pictures = new WeakMap<LabPlan, Map<string, ImageData>>();

type Drawn = Pick<LabRow, 'series' | 'index' | 'competitor'>;

const keyOf = ({ series, index, competitor }: Drawn): string => `${series} ${index} ${competitor}`;

/** Holds what a competitor drew in a case of a plan, as long as the plan is in use. */
export function holdPicture(plan: LabPlan, drawn: Drawn, picture: ImageData): void {
  const held = pictures.get(plan) ?? new Map<string, ImageData>();
  pictures.set(plan, held);
  if (held.size < MOST) held.set(keyOf(drawn), picture);
}

/** What was drawn, or undefined where it is not held. */
export const sharpPicture = (plan: LabPlan, drawn: Drawn): ImageData | undefined =>
  pictures.get(plan)?.get(keyOf(drawn));
