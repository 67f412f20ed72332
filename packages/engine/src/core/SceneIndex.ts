import { Component } from './Component';
import { IndexedList } from './IndexedList';
import { type CameraComponent, isCameraComponent } from './CameraComponent';
import type { RequiredEffect } from './RequiredEffect';
import type { ComponentClass } from './ComponentClass';
import type { GameObject } from './GameObject';

const isOf = (component: Component, type: ComponentClass | string): boolean =>
  typeof type === 'string' ? component.typeName === type : component instanceof type;

const takesObjectPointer = (component: Component): boolean =>
  Boolean(
    component.onPointerOver ??
    component.onPointerOut ??
    component.onPointerPress ??
    component.onPointerRelease ??
    component.onPointerClick,
  );

/** Lists of a scene's components, updated as objects enter and leave, so that no walk of the tree is needed. */
export class SceneIndex {
  readonly objectsById = new Map<string, GameObject>();
  readonly componentsById = new Map<string, Component>();
  /** Components that the scene can be drawn through. */
  readonly cameras = new IndexedList<CameraComponent>();
  /** Effects that components of the scene need, each once. */
  readonly effects = new IndexedList<RequiredEffect>();
  /** Components that override `update`. */
  readonly updated = new IndexedList<Component>();
  /** Components that override `lateUpdate`. */
  readonly late = new IndexedList<Component>();
  /** Components with `start` or `onDestroy` that were not started yet. */
  readonly waiting = new IndexedList<Component>();
  /** Components that were started. */
  readonly started = new IndexedList<Component>();
  /** Components that override a method for pointer events. */
  readonly pointed = new IndexedList<Component>();
  /** Components with a method for pointer events on their object. */
  readonly pointable = new IndexedList<Component>();
  /** Components that override a method for key events. */
  readonly keyed = new IndexedList<Component>();

  /** Components that are no longer called because they threw an error. */
  readonly switchedOff = new Set<Component>();

  /** Component lists by class or type name, made on the first request. */
  private readonly byType = new Map<ComponentClass | string, IndexedList<Component>>();
  private readonly effectUsers = new Map<RequiredEffect, number>();

  /** Components of a class or type name, always as the same array. The first call for a type visits every component. */
  componentsOf(type: ComponentClass | string): readonly Component[] {
    let list = this.byType.get(type);
    if (!list) {
      list = new IndexedList();
      this.byType.set(type, list);
      for (const component of this.componentsById.values()) if (isOf(component, type)) list.add(component);
    }
    return list.array;
  }

  addComponent(component: Component): void {
    this.componentsById.set(component.id, component);
    for (const [type, list] of this.byType) if (isOf(component, type)) list.add(component);
    if (isCameraComponent(component)) this.cameras.add(component);
    this.addToCalls(component);
    if (component.start || component.onDestroy) this.waiting.add(component);
    this.countEffect(component.componentClass.effect, 1);
  }

  /** Stops calling a component until `switchOn`. */
  switchOff(component: Component): void {
    if (this.componentsById.get(component.id) !== component) return;
    this.switchedOff.add(component);
    this.removeFromCalls(component);
  }

  /** Resumes calling all components that `switchOff` stopped. */
  switchOn(): void {
    for (const component of this.switchedOff) this.addToCalls(component);
    this.switchedOff.clear();
  }

  removeComponent(component: Component): void {
    this.componentsById.delete(component.id);
    for (const list of this.byType.values()) list.remove(component);
    if (isCameraComponent(component)) this.cameras.remove(component);
    this.switchedOff.delete(component);
    this.removeFromCalls(component);
    this.waiting.remove(component);
    this.started.remove(component);
    this.countEffect(component.componentClass.effect, -1);
  }

  private addToCalls(component: Component): void {
    if (component.update !== Component.prototype.update) this.updated.add(component);
    if (component.lateUpdate) this.late.add(component);
    if (component.onKeyDown || component.onKeyUp) this.keyed.add(component);
    if (component.onPointerDown || component.onPointerMove || component.onPointerUp || component.onPointerWheel) {
      this.pointed.add(component);
    }
    if (takesObjectPointer(component)) this.pointable.add(component);
  }

  private removeFromCalls(component: Component): void {
    this.updated.remove(component);
    this.late.remove(component);
    this.pointed.remove(component);
    this.pointable.remove(component);
    this.keyed.remove(component);
  }

  /** Adds to the number of components that need an effect. */
  countEffect(effect: RequiredEffect | null, change: 1 | -1): void {
    if (!effect) return;
    const users = (this.effectUsers.get(effect) ?? 0) + change;
    this.effectUsers.set(effect, users);
    if (users > 0) this.effects.add(effect);
    else this.effects.remove(effect);
  }
}
