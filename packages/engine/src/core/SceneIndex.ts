import { Camera } from '../components/Camera';
import { Decal } from '../components/Decal';
import { Light } from '../components/Light';
import { Component } from './Component';
import type { GameObject } from './GameObject';
import { IndexedList } from './IndexedList';

/** The lists by which a scene finds things without walking its tree; kept up to date as objects come and go. */
export class SceneIndex {
  readonly objectsById = new Map<string, GameObject>();
  readonly componentsById = new Map<string, Component>();
  readonly lights = new IndexedList<Light>();
  readonly cameras = new IndexedList<Camera>();
  readonly decals = new IndexedList<Decal>();
  /** Components that override `update`. */
  readonly updated = new IndexedList<Component>();
  /** Components with a pointer method. */
  readonly pointed = new IndexedList<Component>();
  /** Components with a key method. */
  readonly keyed = new IndexedList<Component>();

  addComponent(component: Component): void {
    this.componentsById.set(component.id, component);
    if (component instanceof Light) this.lights.add(component);
    if (component instanceof Camera) this.cameras.add(component);
    if (component instanceof Decal) this.decals.add(component);
    if (component.update !== Component.prototype.update) this.updated.add(component);
    if (component.onKeyDown || component.onKeyUp) this.keyed.add(component);
    if (component.onPointerDown || component.onPointerMove || component.onPointerUp || component.onPointerWheel) {
      this.pointed.add(component);
    }
  }

  removeComponent(component: Component): void {
    this.componentsById.delete(component.id);
    if (component instanceof Light) this.lights.remove(component);
    if (component instanceof Camera) this.cameras.remove(component);
    if (component instanceof Decal) this.decals.remove(component);
    this.updated.remove(component);
    this.pointed.remove(component);
    this.keyed.remove(component);
  }
}
