import type { Scene } from './Scene';
import type { SceneSystem, SceneSystemClass } from './SceneSystem';

/** The systems of a scene, in their order. */
export class SceneSystems {
  private readonly byClass = new Map<SceneSystemClass<SceneSystem>, SceneSystem>();
  private list: SceneSystem[] = [];

  constructor(private readonly scene: Scene) {}

  /** The system of a class, made on the first call. */
  get<T extends SceneSystem>(type: SceneSystemClass<T>): T {
    let system = this.byClass.get(type) as T | undefined;
    if (!system) {
      system = new type(this.scene);
      this.byClass.set(type, system);
      this.list = [...this.list, system].toSorted((a, b) => a.order - b.order);
    }
    return system;
  }

  update(deltaSeconds: number, time: number): void {
    const { list } = this;
    for (let i = 0; i < list.length; i++) list[i].update(deltaSeconds, time);
  }

  pause(): void {
    for (const system of this.list) system.pause?.();
  }

  reset(): void {
    for (const system of this.list) system.reset();
  }

  dispose(): void {
    for (const system of this.list) system.dispose();
    this.byClass.clear();
    this.list = [];
  }
}
