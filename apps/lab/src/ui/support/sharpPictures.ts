import type { LabPlan } from '../../plan/LabPlan';
import type { LabRow } from '../../results/LabRun';

/** Maximum number of pictures of a run in memory: 240 kB each at 320 × 180. */
const MOST = 400;

/** Original pictures of the runs of this session; kept and exported runs have only thumbnails. */
const pictures = new WeakMap<LabPlan, Map<string, ImageData>>();

type Drawn = Pick<LabRow, 'series' | 'index' | 'competitor'>;

const keyOf = ({ series, index, competitor }: Drawn): string => `${series} ${index} ${competitor}`;

/** Stores a competitor's picture of a case in memory as long as the plan is referenced. */
export function holdPicture(plan: LabPlan, drawn: Drawn, picture: ImageData): void {
  const held = pictures.get(plan) ?? new Map<string, ImageData>();
  pictures.set(plan, held);
  if (held.size < MOST) held.set(keyOf(drawn), picture);
}

/** The original picture; undefined if it is not in memory. */
export const sharpPicture = (plan: LabPlan, drawn: Drawn): ImageData | undefined =>
  pictures.get(plan)?.get(keyOf(drawn));
