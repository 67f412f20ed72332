import { shortText } from '@farol/renderer';
import type { Scene as ThreeScene } from 'three';
import { AssetLibrary } from '../assets/AssetLibrary';
import { builtinComponents } from '../components/builtinComponents';
import type { Camera } from '../components/Camera';
import type { ComponentRegistry } from '../components/ComponentRegistry';
import type { Decal } from '../components/Decal';
import type { Light } from '../components/Light';
import type { Component } from './Component';
import type { EngineKeyEvent, EnginePointerEvent } from './events';
import type { GameObject } from './GameObject';
import { InstanceGroups } from './InstanceGroups';
import { PrefabTable } from '../prefabs/PrefabTable';
import { assetFields } from '../fields/assetFields';
import { type GameObjectContainer, moveGameObject } from './moveGameObject';
import type { SceneChange } from './SceneChange';
import { SceneIndex } from './SceneIndex';
import { SceneMicroShaders } from './SceneMicroShaders';
import { sceneFields, SceneSettings } from './SceneSettings';

export interface SceneOptions {
  name?: string;
  /** Where meshes and textures come from. A library of its own, disposed with the scene, when absent. */
  assets?: AssetLibrary;
  /** Known types of components; the built-in ones when absent. */
  registry?: ComponentRegistry;
}

/** A world of GameObjects over one three scene. Any number may exist. */
export class Scene implements GameObjectContainer {
  /** The declaration of the settings, as a component declares its fields. */
  static readonly fields = sceneFields;

  /** @internal ObjectRenderers that are drawn as instances. */
  readonly instances = new InstanceGroups();
  readonly three: ThreeScene = this.instances.root;
  readonly assets: AssetLibrary;
  /** Types of components that can be added by name: by files, prefabs and menus. Another one must have those in use. */
  registry: ComponentRegistry;
  readonly settings: SceneSettings;
  /** Microshaders that are saved with the scene. */
  readonly microShaders = new SceneMicroShaders((name) => this.notify({ kind: 'microshader', name }));
  /**
   * Takes what a component throws while it is updated; the others go on. While null, `update` throws it.
   */
  onComponentError: ((component: Component, error: unknown) => void) | null = null;
  /** What objects of the scene are copies of. */
  readonly prefabs = new PrefabTable(this);
  /** @internal */
  readonly childList: GameObject[] = [];

  private readonly index = new SceneIndex();
  private readonly listeners = new Set<(change: SceneChange) => void>();
  private readonly ownsAssets: boolean;
  private currentCamera: Camera | null = null;
  private ownName: string;
  private seconds = 0;
  private edits = 0;

  constructor(options: SceneOptions = {}) {
    this.ownName = options.name ?? 'Scene';
    this.three.name = this.ownName;
    this.ownsAssets = !options.assets;
    this.assets = options.assets ?? new AssetLibrary();
    this.registry = options.registry ?? builtinComponents;
    this.settings = new SceneSettings(this);
  }

  get name(): string {
    return this.ownName;
  }

  set name(value: string) {
    if (value === this.ownName) return;
    this.ownName = value;
    this.three.name = value;
    this.notify({ kind: 'name' });
  }

  get roots(): readonly GameObject[] {
    return this.childList;
  }

  /** How many objects it has, however deep in the tree. */
  get size(): number {
    return this.index.objectsById.size;
  }

  /** Every Light of the scene, active or not; the same array all along. Its order is not that of the tree. */
  get lights(): readonly Light[] {
    return this.index.lights.array;
  }

  /** Every Camera of the scene, active or not; the same array all along. */
  get cameras(): readonly Camera[] {
    return this.index.cameras.array;
  }

  /** Every Decal of the scene, active or not; the same array all along. */
  get decals(): readonly Decal[] {
    return this.index.decals.array;
  }

  /** The camera to draw with: the first one that came, unless another was chosen; null when the scene has none. */
  get activeCamera(): Camera | null {
    return this.currentCamera;
  }

  set activeCamera(camera: Camera | null) {
    if (camera && !this.index.cameras.has(camera))
      throw new Error('The active camera must be in the scene: add it first.');
    if (camera === this.currentCamera) return;
    this.currentCamera = camera;
    this.notify({ kind: 'active-camera' });
  }

  /** Simulated time in seconds. */
  get time(): number {
    return this.seconds;
  }

  /** Grows by one with each edit; simulation leaves it as it is. */
  get revision(): number {
    return this.edits;
  }

  /** @internal */
  get scene(): Scene {
    return this;
  }

  /** @internal */
  get threeParent(): ThreeScene {
    return this.three;
  }

  /**
   * Adds an object, with all below it, at the top of the tree; out of wherever it was, its local transform kept.
   * @throws Error naming a duplicate id or an unknown asset; nothing has changed then
   */
  add(gameObject: GameObject, index?: number): this {
    moveGameObject(gameObject, this, index, { keepWorld: false });
    return this;
  }

  /** Takes an object out of the scene, wherever in the tree it is; it keeps its ids and may be added again. */
  remove(gameObject: GameObject): this {
    if (gameObject.scene !== this)
      throw new Error(`'${shortText(gameObject.name)}' is not in the scene '${shortText(this.name)}'.`);
    moveGameObject(gameObject, null, undefined, { keepWorld: false });
    return this;
  }

  /** The object with this id, else the first with this name in tree order; null when there is none. */
  find(nameOrId: string): GameObject | null {
    const byId = this.findById(nameOrId);
    if (byId) return byId;
    for (const root of this.childList) {
      const found = root.find(nameOrId);
      if (found) return found;
    }
    return null;
  }

  findById(id: string): GameObject | null {
    return this.index.objectsById.get(id) ?? null;
  }

  findComponentById(id: string): Component | null {
    return this.index.componentsById.get(id) ?? null;
  }

  /** Visits every object, parents first, in tree order. */
  traverse(visit: (gameObject: GameObject) => void): void {
    for (const root of this.childList) root.traverse(visit);
  }

  /** Advances the time and updates every active component that overrides `update`. @param deltaSeconds - 0 or more */
  update(deltaSeconds: number): void {
    this.seconds += deltaSeconds;
    const components = this.index.updated.array;
    for (let i = 0; i < components.length; i++) {
      if (!components[i].isActive) continue;
      try {
        components[i].update(deltaSeconds, this.seconds);
      } catch (error) {
        if (!this.onComponentError) throw error;
        this.onComponentError(components[i], error);
      }
    }
  }

  /** Puts everything whose motion depends on time alone at `seconds`: the same in every run. */
  setTime(seconds: number): void {
    this.seconds = seconds;
    this.update(0);
  }

  /** Undoes simulation: time 0, and every object where it was authored. */
  reset(): void {
    this.traverse((gameObject) => gameObject.transform.restoreAuthored());
    this.setTime(0);
  }

  /** Calls a method of every component of the scene that has it. @returns how many received the call */
  callMethod(name: string, ...args: unknown[]): number {
    let receivers = 0;
    for (const root of [...this.childList]) receivers += root.callMethod(name, ...args);
    return receivers;
  }

  /** Passes a pointer event on to every active component that wants it. */
  dispatchPointer(event: EnginePointerEvent): void {
    const components = this.index.pointed.array;
    for (let i = 0; i < components.length; i++) {
      const component = components[i];
      if (!component.isActive) continue;
      if (event.type === 'move') component.onPointerMove?.(event);
      else if (event.type === 'down') component.onPointerDown?.(event);
      else if (event.type === 'up') component.onPointerUp?.(event);
      else component.onPointerWheel?.(event);
    }
  }

  /** Passes a key event on to every active component that wants it. */
  dispatchKey(event: EngineKeyEvent): void {
    const components = this.index.keyed.array;
    for (let i = 0; i < components.length; i++) {
      const component = components[i];
      if (!component.isActive) continue;
      if (event.type === 'down') component.onKeyDown?.(event);
      else component.onKeyUp?.(event);
    }
  }

  /** Calls `listener` after each edit of structure, fields or settings. @returns a function that ends it */
  onChange(listener: (change: SceneChange) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /** Gives back all that the scene holds. An AssetLibrary that was passed in stays, with what this scene used released. */
  dispose(): void {
    this.listeners.clear();
    for (const root of this.childList.toReversed()) root.dispose();
    this.settings.dispose();
    this.three.clear();
    if (this.ownsAssets) this.assets.dispose();
  }

  /** @internal Counts an edit and tells the listeners. */
  notify(change: SceneChange): void {
    this.edits++;
    for (const listener of this.listeners) listener(change);
  }

  /** @internal @throws Error when an object cannot come in */
  checkSubtree(gameObject: GameObject): void {
    gameObject.traverse((each) => {
      if (this.index.objectsById.has(each.id)) {
        throw new Error(
          `The scene has an object with the id '${shortText(each.id)}' ('${shortText(each.name)}') already: clone() it instead.`,
        );
      }
      for (const component of each.components) this.checkComponent(component);
    });
  }

  /** @internal @throws Error when a component names an asset that nobody knows */
  checkComponent(component: Component): void {
    for (const { name, assetType } of assetFields(component.fields)) {
      const value = component.getAuthored(name);
      const problem = typeof value === 'string' && this.assets.problemWith(assetType, value);
      if (problem) throw new Error(`${component.typeName}.${name} ${problem}`);
    }
  }

  /** @internal */
  subtreeEntered(gameObject: GameObject): void {
    gameObject.sceneOf = this;
    this.index.objectsById.set(gameObject.id, gameObject);
    for (const component of gameObject.components) this.componentEntered(component);
    for (const child of gameObject.children) this.subtreeEntered(child);
  }

  /** @internal */
  subtreeLeaves(gameObject: GameObject): void {
    for (const child of gameObject.children) this.subtreeLeaves(child);
    for (const component of gameObject.components) this.componentLeaves(component);
    this.index.objectsById.delete(gameObject.id);
    gameObject.sceneOf = null;
  }

  /** @internal */
  componentEntered(component: Component): void {
    this.index.addComponent(component);
    component.onEnterScene(this);
    if (!this.currentCamera && this.cameras.length > 0) this.currentCamera = this.cameras[0];
  }

  /** @internal */
  componentLeaves(component: Component): void {
    component.onLeaveScene(this);
    this.index.removeComponent(component);
    if (component === (this.currentCamera as Component | null)) this.currentCamera = this.cameras[0] ?? null;
  }
}
