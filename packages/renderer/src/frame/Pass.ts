import type { Frame } from './Frame';
import type { ResourceUser } from './Resources';

export type { Resource } from './Resources';

/** One step of a technique. It owns its targets and programs. */
export interface Pass extends ResourceUser {
  /** Name of the pass in `FarolInfo.passes`. */
  readonly name: string;
  /** Sources of the pass's own microshaders, by name. Default none. */
  readonly microShaders?: Readonly<Record<string, string>>;
  /**
   * Draws, and puts the resources named in `writes` into `frame.resources`. Called inside three's `render`; must not
   * allocate in steady state.
   */
  render(frame: Frame): void;
  /** Called in place of `render` while programs are compiled ahead; needed by passes that do not draw by methods of `frame`. */
  warmUp?(frame: Frame): void;
  /** Whether `render` draws nothing in this frame, so that it is not timed. Default: unknown, so it is timed. */
  isIdle?(frame: Frame): boolean;
  /** Bytes of the targets that the pass holds. */
  readonly bytes: number;
  /** Frees targets and programs; `render` creates them again. */
  dispose(): void;
}
