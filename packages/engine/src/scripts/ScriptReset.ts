import type { SceneSystem } from '../core/SceneSystem';

/** Notifies the scripts of a scene of its reset. */
export class ScriptReset implements SceneSystem {
  readonly order = 0;
  onReset: (() => void) | null = null;

  update(): void {}

  reset(): void {
    this.onReset?.();
  }

  dispose(): void {}
}
