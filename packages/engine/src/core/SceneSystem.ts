import type { Scene } from './Scene';

/** A part of the simulation that works on many components at once, such as physics: see `Scene.system`. */
export interface SceneSystem {
  /** Lower ones come first: animation is 100, physics 200. */
  readonly order: number;
  /**
   * Called in each frame that is simulated, after every component's `update` and before every `lateUpdate`.
   * @param deltaSeconds - 0 when the scene was put at a time
   * @param time - the scene's time in seconds
   */
  update(deltaSeconds: number, time: number): void;
  /** The simulation is held: the next `update` may come much later. */
  pause?(): void;
  /** The scene was reset: time 0, all as it was authored. */
  reset(): void;
  /** Gives back what it holds. It is not used afterwards. */
  dispose(): void;
}

/** A class of systems, of which a scene has one at most. */
export type SceneSystemClass<T extends SceneSystem> = new (scene: Scene) => T;
