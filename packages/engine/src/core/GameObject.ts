import { shortText } from '@farol/editing';
import type { FieldValue } from '@farol/editing/fields';
import { Object3D } from 'three';
import type { PrefabLink } from './Prefab';
import { builtinComponents } from './builtinComponents';
import { createId } from '../base/createId';
import { checkComponent } from './admission';
import { setGameObjectOf } from './gameObjectOf';
import { makeRotationLazy } from './LazyEuler';
import { moveGameObject, type MoveOptions } from './moveGameObject';
import type { Component } from './Component';
import type { ComponentClass } from './ComponentClass';
import type { GameObjectContainer } from './GameObjectContainer';
import type { Scene } from './Scene';
import { Transform } from './Transform';
import { UnknownComponent } from './UnknownComponent';

/** Options of `addComponent`: the new component's id and place. */
export interface AddComponentOptions {
  /** Place among the components; at the end when absent. Place 0 is the Transform's. */
  index?: number;
  /** Id of the component; by default made from the object's id. */
  id?: string;
  enabled?: boolean;
}

type Values = Readonly<Record<string, FieldValue>>;

/**
 * Node of the scene's tree. It has no behaviour of its own, but children and components, which receive updates, events
 * and calls. It owns one three object, `object3D`; its front is that object's -Z axis.
 */
export class GameObject implements GameObjectContainer {
  readonly id: string;
  readonly object3D = new Object3D();
  /** The first component, always present. */
  readonly transform: Transform;
  /** @internal */
  readonly childList: GameObject[] = [];
  /** @internal The parent object or the scene; null for none. */
  container: GameObjectContainer | null = null;
  /** @internal */
  sceneOf: Scene | null = null;

  private readonly componentList: Component[] = [];
  private ownName: string;
  private ownTags: readonly string[] = [];
  private link: PrefabLink | null = null;
  private isActive = true;
  private isLocked = false;
  private staysInPlace = false;
  private activeWithParents = true;

  /** @param options - `id`: unique in its scene, random when absent */
  constructor(name = 'Object', options: { id?: string } = {}) {
    this.id = options.id ?? createId();
    this.ownName = name;
    this.object3D.name = name;
    makeRotationLazy(this.object3D);
    setGameObjectOf(this.object3D, this);
    this.transform = this.addComponent(Transform);
  }

  get name(): string {
    return this.ownName;
  }

  set name(value: string) {
    if (value === this.ownName) return;
    this.ownName = value;
    this.object3D.name = value;
    this.scene?.notify({ kind: 'object', gameObject: this, property: 'name' });
  }

  get tags(): readonly string[] {
    return this.ownTags;
  }

  set tags(value: readonly string[]) {
    this.ownTags = Object.freeze([...value]);
    this.scene?.notify({ kind: 'object', gameObject: this, property: 'tags' });
  }

  /** The prefab's object that this one is a copy of; null when it is a copy of none. */
  get prefabLink(): PrefabLink | null {
    return this.link;
  }

  set prefabLink(value: PrefabLink | null) {
    if (value === this.link) return;
    this.link = value;
    this.scene?.notify({ kind: 'object', gameObject: this, property: 'prefab' });
  }

  /** False hides the object and its children, and stops their updates and events. */
  get active(): boolean {
    return this.isActive;
  }

  set active(value: boolean) {
    if (value === this.isActive) return;
    this.isActive = value;
    this.object3D.visible = value;
    this.refreshActive();
    this.scene?.notify({ kind: 'object', gameObject: this, property: 'active' });
  }

  /** Whether editors do not pick the object and its descendants in the picture; has no other effect. */
  get locked(): boolean {
    return this.isLocked;
  }

  set locked(value: boolean) {
    if (value === this.isLocked) return;
    this.isLocked = value;
    this.scene?.notify({ kind: 'object', gameObject: this, property: 'locked' });
  }

  /** Whether the object never moves, so that its meshes get baked lightmaps. Children have flags of their own. */
  get isStatic(): boolean {
    return this.staysInPlace;
  }

  set isStatic(value: boolean) {
    if (value === this.staysInPlace) return;
    this.staysInPlace = value;
    this.scene?.notify({ kind: 'object', gameObject: this, property: 'static' });
  }

  /** Whether the object or an ancestor is locked. */
  get lockedInHierarchy(): boolean {
    return this.isLocked || (this.parent?.lockedInHierarchy ?? false);
  }

  /** Whether the object and all its ancestors are active. */
  get activeInHierarchy(): boolean {
    return this.activeWithParents;
  }

  get parent(): GameObject | null {
    return this.container === this.sceneOf ? null : (this.container as GameObject | null);
  }

  get children(): readonly GameObject[] {
    return this.childList;
  }

  get components(): readonly Component[] {
    return this.componentList;
  }

  /** The scene that contains the object; null for none. */
  get scene(): Scene | null {
    return this.sceneOf;
  }

  /** @internal Parent of the children's three objects. */
  get threeParent(): Object3D {
    return this.object3D;
  }

  /** Adds a child, or moves it from another parent; its local transform is kept. @throws Error for a cycle */
  add(child: GameObject, index?: number): this {
    moveGameObject(child, this, index, { keepWorld: false });
    return this;
  }

  /**
   * Removes a child with all its descendants; the child may be added again.
   * @throws Error when `child` is no child of this object
   */
  remove(child: GameObject): this {
    if (child.container !== this)
      throw new Error(
        `'${shortText(child.name)}' is not a child of '${shortText(this.name)}': call remove of its parent.`,
      );
    moveGameObject(child, null, undefined, { keepWorld: false });
    return this;
  }

  /**
   * Moves the object below another, or to the top of a scene.
   * @param index - place among the new siblings; at the end when absent
   * @param options - `keepWorld` (default true): it keeps its pose in the world. Under a parent with unequal scales a
   *   rotated object would need shear, which a Transform cannot represent; the nearest pose is used.
   * @throws Error when the new parent is the object itself or below it; nothing has changed then
   */
  reparent(parent: GameObject | Scene, index?: number, options: MoveOptions = {}): void {
    moveGameObject(this, parent, index, { keepWorld: options.keepWorld ?? true });
  }

  /**
   * Puts a component on the object.
   * @param type - class, type name, or a component that is on no object
   * @param values - field values in place of the defaults
   * @throws Error for an unknown type name or a second component of a unique type; FieldError for a wrong value
   */
  addComponent<T extends Component>(type: ComponentClass<T> | T, values?: Values, options?: AddComponentOptions): T;
  addComponent(type: string, values?: Values, options?: AddComponentOptions): Component;
  addComponent(
    type: string | ComponentClass | Component,
    values: Values = {},
    options: AddComponentOptions = {},
  ): Component {
    const registry = this.scene?.registry ?? builtinComponents;
    const component = typeof type === 'string' ? registry.create(type) : typeof type === 'function' ? new type() : type;
    if (component.isAttached)
      throw new Error(
        `This ${component.typeName} is on '${shortText(component.gameObject.name)}' already: remove it there first.`,
      );
    if (component.componentClass.unique && this.getComponent(component.typeName)) {
      throw new Error(
        `'${shortText(this.name)}' has a ${component.typeName} already: change that one, or remove it first.`,
      );
    }
    for (const name of Object.keys(values)) component.set(name, values[name]);
    if (options.enabled === false) component.enabled = false;
    if (this.scene) checkComponent(this.scene, component);
    const least = this.componentList.length === 0 ? 0 : 1;
    const index = Math.min(Math.max(options.index ?? Infinity, least), this.componentList.length);
    this.componentList.splice(index, 0, component);
    component.attachTo(this, options.id ?? (component.id || this.componentId(component.typeName)));
    this.scene?.componentEntered(component);
    this.scene?.notify({ kind: 'component-add', gameObject: this, component });
    return component;
  }

  /**
   * Removes a component, which may be added again or disposed of.
   * @throws Error for the Transform, or for another object's component
   */
  removeComponent(component: Component): void {
    const index = this.componentList.indexOf(component);
    if (index < 0) throw new Error(`This ${component.typeName} is not on '${shortText(this.name)}': give one that is.`);
    if (component === this.transform)
      throw new Error('The Transform cannot be removed: dispose of the object instead.');
    this.scene?.componentLeaves(component);
    component.detach();
    this.componentList.splice(index, 1);
    this.scene?.notify({ kind: 'component-remove', gameObject: this, component });
  }

  /** @internal Replaces a component by another one in the list, without calling a method of either. */
  putInPlace(component: Component, other: Component): void {
    this.componentList[this.componentList.indexOf(component)] = other;
  }

  /** Moves a component to another place in the list; the Transform stays first. */
  moveComponent(component: Component, index: number): void {
    const from = this.componentList.indexOf(component);
    if (from < 1)
      throw new Error(
        `This ${component.typeName} cannot be moved: give one of '${shortText(this.name)}', not the Transform.`,
      );
    this.componentList.splice(from, 1);
    this.componentList.splice(Math.min(Math.max(index, 1), this.componentList.length), 0, component);
    this.scene?.notify({ kind: 'component-move', gameObject: this, component });
  }

  /** The first component of a class (or of one derived from it), or of a type name; null when there is none. */
  getComponent<T extends Component>(type: ComponentClass<T>): T | null;
  getComponent(type: string): Component | null;
  getComponent(type: string | ComponentClass): Component | null {
    for (const component of this.componentList) {
      if (typeof type === 'string' ? component.typeName === type : component instanceof type) return component;
    }
    return null;
  }

  /** All components of a class, or of a type name. */
  getComponents<T extends Component>(type: ComponentClass<T>): T[];
  getComponents(type: string): Component[];
  getComponents(type: string | ComponentClass): Component[] {
    return this.componentList.filter((component) =>
      typeof type === 'string' ? component.typeName === type : component instanceof type,
    );
  }

  /** Updates the object's active components, then its children. A Scene does so from flat lists instead. */
  update(deltaSeconds: number, time: number): void {
    if (!this.isActive) return;
    for (const component of this.componentList) if (component.enabled) component.update(deltaSeconds, time);
    for (const child of this.childList) child.update(deltaSeconds, time);
  }

  /**
   * Calls a method of every component that has it, on the object and all its descendants (thesis 3.2.4), active or not.
   * @returns how many components received the call
   */
  callMethod(name: string, ...args: unknown[]): number {
    if (name in Object.prototype) throw new Error(`'${name}' is a method of every object: call another.`);
    let receivers = 0;
    for (const component of [...this.componentList]) {
      const method = (component as unknown as Record<string, unknown>)[name];
      if (typeof method !== 'function' || this.scene?.isSwitchedOff(component)) continue;
      receivers++;
      const { scene } = this;
      try {
        method.apply(component, args);
      } catch (error) {
        if (!scene) throw error;
        scene.reportError(component, error);
      }
    }
    for (const child of [...this.childList]) receivers += child.callMethod(name, ...args);
    return receivers;
  }

  /** Visits the object and all its descendants, parents first. */
  traverse(visit: (gameObject: GameObject) => void): void {
    visit(this);
    for (const child of this.childList) child.traverse(visit);
  }

  /** The first object with this id, else with this name, among this object and its descendants; null for none. */
  find(nameOrId: string): GameObject | null {
    let byName: GameObject | null = null;
    let byId: GameObject | null = null;
    this.traverse((gameObject) => {
      if (gameObject.id === nameOrId) byId ??= gameObject;
      if (gameObject.name === nameOrId) byName ??= gameObject;
    });
    return byId ?? byName;
  }

  /**
   * Makes a copy with all descendants and new ids, in no scene. References between copied objects lead to the copies.
   * The copy of a prefab instance is an instance; the copy of a part of one is a plain object.
   */
  clone(): GameObject {
    const newIds = new Map<string, string>();
    this.traverse((gameObject) => newIds.set(gameObject.id, createId()));
    return copyOf(this, newIds, new Set());
  }

  /** Removes the object from its parent or scene, and disposes of it and all its descendants. */
  dispose(): void {
    if (this.scene?.holds(this)) return;
    if (this.container) moveGameObject(this, null, undefined, { keepWorld: false });
    // from the last child: removal at the end of a list is cheap
    for (const child of this.childList.toReversed()) child.dispose();
    for (const component of this.componentList.toReversed()) {
      component.detach();
      component.dispose();
    }
    this.componentList.length = 0;
  }

  /** @internal Called when `active` changed on the object or an ancestor. */
  refreshActive(): void {
    const active = this.isActive && (this.parent?.activeInHierarchy ?? true);
    if (active === this.activeWithParents) return;
    this.activeWithParents = active;
    for (const component of this.componentList) component.onActiveChanged();
    for (const child of this.childList) child.refreshActive();
  }

  private componentId(typeName: string): string {
    const base = `${this.id}:${typeName}`;
    const taken = new Set(this.componentList.map(({ id }) => id));
    let id = base;
    for (let n = 2; taken.has(id); n++) id = `${base}${n}`;
    return id;
  }
}

/**
 * Copies an object with its descendants.
 * @param newIds - ids of the copies, by the ids of their originals
 * @param prefabs - prefabs of instances whose root is copied too; links to all others are left out
 */
function copyOf(source: GameObject, newIds: ReadonlyMap<string, string>, prefabs: ReadonlySet<string>): GameObject {
  const copy = new GameObject(source.name, { id: newIds.get(source.id) });
  copy.tags = source.tags;
  const { prefabLink: link } = source;
  const isRoot = link !== null && link.source === link.prefab;
  const within = isRoot ? new Set([...prefabs, link.prefab]) : prefabs;
  if (link && within.has(link.prefab)) copy.prefabLink = link;
  for (const component of source.components) {
    const values = component.authoredValues();
    for (const [name, field] of Object.entries(component.fields)) {
      const value = values[name];
      const mayRefer = field.kind === 'object' || component instanceof UnknownComponent;
      if (mayRefer && typeof value === 'string') values[name] = newIds.get(value) ?? value;
    }
    if (component === source.transform) for (const name in values) copy.transform.set(name, values[name]);
    else {
      const id = component.id.startsWith(`${source.id}:`) ? copy.id + component.id.slice(source.id.length) : undefined;
      copy.addComponent(component.componentClass, values, { enabled: component.enabled, id });
    }
  }
  for (const child of source.children) copy.add(copyOf(child, newIds, within));
  copy.active = source.active;
  copy.locked = source.locked;
  copy.isStatic = source.isStatic;
  return copy;
}
