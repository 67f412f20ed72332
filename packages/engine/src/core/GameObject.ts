import { shortText } from '@farol/editing';
import type { FieldValue } from '@farol/editing/fields';
import { Object3D } from 'three';
import type { PrefabLink } from './Prefab';
import { builtinComponents } from './builtinComponents';
import { createId } from '../base/createId';
import { setGameObjectOf } from './gameObjectOf';
import { makeRotationLazy } from './LazyEuler';
import { moveGameObject } from './moveGameObject';
import type {
  AddComponentOptions,
  Component,
  ComponentClass,
  GameObject as GameObjectType,
  GameObjectContainer,
  MoveOptions,
  Scene,
} from './SceneGraph';
import { Transform } from './Transform';
import { UnknownComponent } from './UnknownComponent';

type Values = Readonly<Record<string, FieldValue>>;

/** See the interface. */
class BaseGameObject implements GameObjectType {
  readonly id: string;
  readonly object3D = new Object3D();
  readonly transform: Transform;
  readonly childList: GameObject[] = [];
  container: GameObjectContainer | null = null;
  sceneOf: Scene | null = null;

  private readonly componentList: Component[] = [];
  private ownName: string;
  private ownTags: readonly string[] = [];
  private link: PrefabLink | null = null;
  private isActive = true;
  private isLocked = false;
  private staysInPlace = false;
  private activeWithParents = true;

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

  get prefabLink(): PrefabLink | null {
    return this.link;
  }

  set prefabLink(value: PrefabLink | null) {
    if (value === this.link) return;
    this.link = value;
    this.scene?.notify({ kind: 'object', gameObject: this, property: 'prefab' });
  }

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

  get locked(): boolean {
    return this.isLocked;
  }

  set locked(value: boolean) {
    if (value === this.isLocked) return;
    this.isLocked = value;
    this.scene?.notify({ kind: 'object', gameObject: this, property: 'locked' });
  }

  get isStatic(): boolean {
    return this.staysInPlace;
  }

  set isStatic(value: boolean) {
    if (value === this.staysInPlace) return;
    this.staysInPlace = value;
    this.scene?.notify({ kind: 'object', gameObject: this, property: 'static' });
  }

  get lockedInHierarchy(): boolean {
    return this.isLocked || (this.parent?.lockedInHierarchy ?? false);
  }

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

  get scene(): Scene | null {
    return this.sceneOf;
  }

  get threeParent(): Object3D {
    return this.object3D;
  }

  add(child: GameObject, index?: number): this {
    moveGameObject(child, this, index, { keepWorld: false });
    return this;
  }

  remove(child: GameObject): this {
    if (child.container !== this)
      throw new Error(`'${shortText(child.name)}' is no child of '${shortText(this.name)}'.`);
    moveGameObject(child, null, undefined, { keepWorld: false });
    return this;
  }

  reparent(parent: GameObject | Scene, index?: number, options: MoveOptions = {}): void {
    moveGameObject(this, parent, index, { keepWorld: options.keepWorld ?? true });
  }

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
      throw new Error(`This ${component.typeName} is already on '${shortText(component.gameObject.name)}'.`);
    if (component.componentClass.unique && this.getComponent(component.typeName)) {
      throw new Error(`'${shortText(this.name)}' has a ${component.typeName} already, and can have one only.`);
    }
    for (const name of Object.keys(values)) component.set(name, values[name]);
    if (options.enabled === false) component.enabled = false;
    this.scene?.checkComponent(component);
    const least = this.componentList.length === 0 ? 0 : 1;
    const index = Math.min(Math.max(options.index ?? Infinity, least), this.componentList.length);
    this.componentList.splice(index, 0, component);
    component.attachTo(this, options.id ?? (component.id || this.componentId(component.typeName)));
    this.scene?.componentEntered(component);
    this.scene?.notify({ kind: 'component-add', gameObject: this, component });
    return component;
  }

  removeComponent(component: Component): void {
    const index = this.componentList.indexOf(component);
    if (index < 0) throw new Error(`This ${component.typeName} is not on '${shortText(this.name)}'.`);
    if (component === this.transform) throw new Error('The Transform cannot be removed.');
    this.scene?.componentLeaves(component);
    component.detach();
    this.componentList.splice(index, 1);
    this.scene?.notify({ kind: 'component-remove', gameObject: this, component });
  }

  moveComponent(component: Component, index: number): void {
    const from = this.componentList.indexOf(component);
    if (from < 1) throw new Error(`This ${component.typeName} cannot be moved within '${shortText(this.name)}'.`);
    this.componentList.splice(from, 1);
    this.componentList.splice(Math.min(Math.max(index, 1), this.componentList.length), 0, component);
    this.scene?.notify({ kind: 'component-move', gameObject: this, component });
  }

  getComponent<T extends Component>(type: ComponentClass<T>): T | null;
  getComponent(type: string): Component | null;
  getComponent(type: string | ComponentClass): Component | null {
    for (const component of this.componentList) {
      if (typeof type === 'string' ? component.typeName === type : component instanceof type) return component;
    }
    return null;
  }

  getComponents<T extends Component>(type: ComponentClass<T>): T[];
  getComponents(type: string): Component[];
  getComponents(type: string | ComponentClass): Component[] {
    return this.componentList.filter((component) =>
      typeof type === 'string' ? component.typeName === type : component instanceof type,
    );
  }

  update(deltaSeconds: number, time: number): void {
    if (!this.isActive) return;
    for (const component of this.componentList) if (component.enabled) component.update(deltaSeconds, time);
    for (const child of this.childList) child.update(deltaSeconds, time);
  }

  callMethod(name: string, ...args: unknown[]): number {
    if (name in Object.prototype) throw new Error(`'${name}' is a method of every object: it cannot be propagated.`);
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

  traverse(visit: (gameObject: GameObject) => void): void {
    visit(this);
    for (const child of this.childList) child.traverse(visit);
  }

  find(nameOrId: string): GameObject | null {
    let byName: GameObject | null = null;
    let byId: GameObject | null = null;
    this.traverse((gameObject) => {
      if (gameObject.id === nameOrId) byId ??= gameObject;
      if (gameObject.name === nameOrId) byName ??= gameObject;
    });
    return byId ?? byName;
  }

  clone(): GameObject {
    const newIds = new Map<string, string>();
    this.traverse((gameObject) => newIds.set(gameObject.id, createId()));
    return copyOf(this, newIds, new Set());
  }

  dispose(): void {
    if (this.scene?.holds(this)) return;
    if (this.container) moveGameObject(this, null, undefined, { keepWorld: false });
    // from the last one on: each leaves the end of its list
    for (const child of this.childList.toReversed()) child.dispose();
    for (const component of this.componentList.toReversed()) {
      component.detach();
      component.dispose();
    }
    this.componentList.length = 0;
  }

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
 * A copy of an object with all below it.
 * @param newIds - the id of each copy, by that of the object
 * @param prefabs - those of which the copy holds the root of an instance, from here upwards
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

export type GameObject = GameObjectType;

/** @param options - `id`: unique in its scene, random when absent */
export const GameObject: new (name?: string, options?: { id?: string }) => GameObject = BaseGameObject;
