/** Progress of a bake. */
export interface BakeProgress {
  readonly stage: 'unwrapping' | 'preparing' | 'tracing' | 'finishing';
  /** Share of the whole that is done, 0 to 1. Never falls. */
  readonly share: number;
  /** Number of paths per texel or probe so far. */
  readonly samples: number;
  /** Estimated remaining time (s); null while it is unknown. */
  readonly secondsLeft: number | null;
}
