import type { SceneSystem } from '../core/SceneSystem';

/** Tells the scripts of a scene that it was reset. */
export class ScriptReset implements SceneSystem {
  readonly order = 0;
  onReset: (() => void) | null = null;

  update(): void {}

  reset(): void {
    this.onReset?.();
  }

  dispose(): void {}
}
