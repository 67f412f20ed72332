/** Space of a scene's moving lights, and their range and intensity while few. */
export interface LightBudget {
  /** Space that the lights share, in m³. */
  volume: number;
  /** Range of a light while lights are few, in metres. */
  range: number;
  /** Intensity of a light while lights are few, in candela. */
  light: number;
}

/**
 * Range (m) and intensity (cd) of each of `count` lights, so that a scene is well exposed without tone mapping with ten
 * lights or with thousands: the more lights overlap, the smaller and the dimmer each one is.
 */
export function lightBudget(count: number, budget: LightBudget): { range: number; intensity: number } {
  const comfortable = 4;
  const overlap = (range: number): number => (count * 4.19 * range ** 3) / budget.volume;
  const crowd = Math.max(1, overlap(budget.range) / comfortable);
  const range = Math.max(budget.range * crowd ** -0.22, budget.range * 0.3);
  const left = Math.max(1, overlap(range) / comfortable);
  return { range: round(range), intensity: round((budget.light * (range / budget.range) ** 2) / left ** 0.6) };
}

const round = (value: number): number => Math.round(value * 1000) / 1000;
