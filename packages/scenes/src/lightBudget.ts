/** Space that a scene's moving lights share, and the range and intensity of each while they are few. */
export interface LightBudget {
  /** Volume that the lights share (m³). */
  volume: number;
  /** Range of a light (m) while lights are few. */
  range: number;
  /** Intensity of a light (cd) while lights are few. */
  light: number;
}

/**
 * Range (m) and intensity (cd) of each of `count` lights, so that exposure is right without tone mapping for ten lights
 * as for thousands: the more lights overlap, the smaller and dimmer each one is.
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
