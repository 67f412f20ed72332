import type { FarolEffect } from '@farol/renderer';

/** Renderer effect that a component needs to be visible; the component's class names it as `effect`. */
export interface RequiredEffect {
  /** Class of the effect; null until `load` is done. */
  readonly effectClass: (new () => FarolEffect) | null;
  /** Fetches the code of the effect. @throws Error (as a rejection) when it cannot be fetched; call again */
  load(): Promise<unknown>;
}
