import type { Component } from './Component';
import type { EngineKeyEvent, EnginePointerEvent } from './events';
import type { Scene } from './Scene';
import type { SceneIndex } from './SceneIndex';
import { scriptClasses } from './scriptClasses';

const update = (component: Component, deltaSeconds: number, time: number): void => component.update(deltaSeconds, time);

const lateUpdate = (component: Component, deltaSeconds: number, time: number): void =>
  component.lateUpdate!(deltaSeconds, time);

function pointer(component: Component, event: EnginePointerEvent): void {
  if (event.type === 'move') component.onPointerMove?.(event);
  else if (event.type === 'down') component.onPointerDown?.(event);
  else if (event.type === 'up') component.onPointerUp?.(event);
  else if (event.type === 'wheel') component.onPointerWheel?.(event);
}

function key(component: Component, event: EngineKeyEvent): void {
  if (event.type === 'down') component.onKeyDown?.(event);
  else component.onKeyUp?.(event);
}

/**
 * Calls methods of a scene's active components in turn. An error of one is reported to the scene; the others continue.
 */
export class ComponentCalls {
  constructor(
    private readonly scene: Scene,
    private readonly index: SceneIndex,
  ) {}

  update(deltaSeconds: number, time: number): void {
    this.updateAll(this.index.updated.array, update, deltaSeconds, time);
  }

  lateUpdate(deltaSeconds: number, time: number): void {
    this.updateAll(this.index.late.array, lateUpdate, deltaSeconds, time);
  }

  pointer(event: EnginePointerEvent): void {
    this.tellAll(this.index.pointed.array, pointer, event);
  }

  key(event: EngineKeyEvent): void {
    this.tellAll(this.index.keyed.array, key, event);
  }

  /** Starts every active component not started yet, including components that a `start` adds. */
  start(): void {
    const { waiting, started } = this.index;
    for (let i = 0; i < waiting.array.length;) {
      const component = waiting.array[i];
      if (!component.isActive) {
        i++;
        continue;
      }
      // `i` stays, since IndexedList moves the last entry to the place of the removed one
      waiting.remove(component);
      started.add(component);
      try {
        component.start?.();
      } catch (error) {
        this.scene.reportError(component, error);
      }
    }
  }

  /** Ends a component that was started; it may be started again. */
  destroy(component: Component): void {
    if (!this.index.started.has(component)) return;
    this.index.started.remove(component);
    this.index.waiting.add(component);
    try {
      component.onDestroy?.();
    } catch (error) {
      this.scene.reportError(component, error);
    }
  }

  /** Calls `onDestroy` of every component that was started. */
  destroyAll(): void {
    for (const component of [...this.index.started.array]) this.destroy(component);
  }

  private updateAll(list: readonly Component[], call: typeof update, deltaSeconds: number, time: number): void {
    for (let i = 0; i < list.length; i++) {
      const component = list[i];
      if (!component.isActive || this.isTooEarly(component, deltaSeconds)) continue;
      try {
        call(component, deltaSeconds, time);
      } catch (error) {
        this.scene.reportError(component, error);
      }
      // the component was removed, and IndexedList moved its last entry to place `i`, which is visited again
      if (list[i] !== component) i--;
    }
  }

  private tellAll<E>(list: readonly Component[], call: (component: Component, event: E) => void, event: E): void {
    for (let i = 0; i < list.length; i++) {
      const component = list[i];
      if (!component.isActive) continue;
      try {
        call(component, event);
      } catch (error) {
        this.scene.reportError(component, error);
      }
      if (list[i] !== component) i--;
    }
  }

  /**
   * Whether a component must not be updated: it was added in this frame and starts in the next, or it is a script's and
   * the scene is only moved to a time (`deltaSeconds` 0).
   */
  private isTooEarly(component: Component, deltaSeconds: number): boolean {
    if (deltaSeconds === 0) return scriptClasses.has(component.componentClass);
    const { waiting } = this.index;
    return waiting.array.length > 0 && waiting.has(component);
  }
}
