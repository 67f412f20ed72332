/** Progress of a bake. */
export interface BakeProgress {
  readonly stage: 'unwrapping' | 'preparing' | 'tracing' | 'finishing';
  /** Share of the whole that is done, 0 to 1. Never falls. */
  readonly share: number;
  /** Paths at each texel or probe so far. */
  readonly samples: number;
  /** Seconds that the rest takes by the pace so far; null as long as there is none. */
  readonly secondsLeft: number | null;
}
