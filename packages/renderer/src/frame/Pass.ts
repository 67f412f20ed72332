import type { Frame } from './Frame';

/** A thing passes hand to one another. `target` is what the host draws to; it is there from the start. */
export type Resource =
  'target' | 'gbuffer' | 'thin-gbuffer' | 'lighting' | 'light-lists' | 'light-buffer' | 'scene-depth';

/** One step of a technique. It owns its targets and programs. */
export interface Pass {
  readonly name: string;
  readonly reads: readonly Resource[];
  readonly writes: readonly Resource[];
  /** Draws. Called inside three's `render`; must not allocate in steady state. */
  render(frame: Frame): void;
  /** Bytes of the targets that the pass holds. */
  readonly bytes: number;
  dispose(): void;
}
