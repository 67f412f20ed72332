import type { BakeProgress } from './BakeProgress';

/** Share of the whole bake, 0 to 1, at which each stage begins. */
const begins = { unwrapping: 0, preparing: 0.1, tracing: 0.15, finishing: 0.97 } as const;
const ends = { unwrapping: 0.1, preparing: 0.15, tracing: 0.97, finishing: 1 } as const;

/** Reports the progress of a bake to the host. */
export class Progress {
  private share = 0;
  private begun = 0;

  constructor(private readonly tell: ((progress: BakeProgress) => void) | undefined) {}

  /** @param done - share of the stage that is done, 0 to 1 */
  report(stage: BakeProgress['stage'], done: number, samples = 0): void {
    const now = performance.now();
    if (stage === 'tracing' && this.begun === 0) this.begun = now;
    this.share = Math.max(this.share, begins[stage] + done * (ends[stage] - begins[stage]));
    const isPaced = stage === 'tracing' && done > 0.01;
    const secondsLeft = isPaced ? ((now - this.begun) * (1 - done)) / done / 1000 : stage === 'finishing' ? 0 : null;
    this.tell?.({ stage, share: this.share, samples, secondsLeft });
  }
}
