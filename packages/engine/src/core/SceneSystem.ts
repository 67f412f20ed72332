import type { Scene } from './Scene';

/** A part of the simulation that works on many components at once, such as physics: see `Scene.system`. */
export interface SceneSystem {
  /** Order of updates, lower first: animation is 100, physics 200. */
  readonly order: number;
  /**
   * Called in each frame that is simulated, after every component's `update` and before every `lateUpdate`.
   * @param deltaSeconds - 0 when the scene was moved to a time
   * @param time - the scene's time in seconds
   */
  update(deltaSeconds: number, time: number): void;
  /** Called when the simulation pauses: the next `update` may come much later. */
  pause?(): void;
  /** Called after the scene was reset to time 0 and its authored state. */
  reset(): void;
  /** Releases the system's resources; the system is not used afterwards. */
  dispose(): void;
}

/** A class of systems, of which a scene has one at most. */
export type SceneSystemClass<T extends SceneSystem> = new (scene: Scene) => T;
