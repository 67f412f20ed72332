import { shortText } from '@farol/editing';
import type { Camera as ThreeCamera, Scene as ThreeScene } from 'three';
import { AssetLibrary } from '../assets/AssetLibrary';
import { PrefabTable } from './PrefabTable';
import { AuthoredState } from './AuthoredState';
import { builtinComponents } from './builtinComponents';
import type { EngineKeyEvent, EnginePointerEvent } from './events';
import { moveGameObject } from './moveGameObject';
import type { GameObjectContainer } from './GameObjectContainer';
import type { RequiredEffect } from './RequiredEffect';
import type { CameraComponent } from './CameraComponent';
import type { Component } from './Component';
import { ComponentCalls } from './ComponentCalls';
import type { ComponentClass } from './ComponentClass';
import type { ComponentRegistry } from './ComponentRegistry';
import type { GameObject } from './GameObject';
import type { SceneChange } from './SceneChange';
import type { SceneSystem, SceneSystemClass } from './SceneSystem';
import { SceneIndex } from './SceneIndex';
import type { SceneOptions } from './SceneOptions';
import type { ScenePicture } from './ScenePicture';
import { ScenePointer } from './ScenePointer';
import { scriptClasses } from './scriptClasses';
import { SceneBake } from './baked/SceneBake';
import { SceneMicroShaders } from './SceneMicroShaders';
import { SceneSystems } from './SceneSystems';
import { SceneViews } from './SceneViews';
import { SceneRoot } from './SceneRoot';
import { SceneSettings } from '../settings/SceneSettings';

/** Tree of GameObjects drawn as one three scene. Any number of scenes may exist. */
export class Scene implements GameObjectContainer {
  readonly three = new SceneRoot();
  readonly assets: AssetLibrary;
  /** Types of components that files, prefabs and menus can add by name. Another registry must have all types in use. */
  registry: ComponentRegistry;
  readonly settings: SceneSettings;
  /** Microshaders that are saved with the scene. */
  readonly microShaders = new SceneMicroShaders((name) => this.notify({ kind: 'microshader', name }));
  /** Camera bookmarks that editors keep with the scene. */
  readonly views = new SceneViews((place) => this.notify({ kind: 'view', place }));
  /** Thumbnail that editors show for the scene's file; null for none. */
  picture: ScenePicture | null = null;
  /** Baked light of the scene. */
  readonly baked: SceneBake = new SceneBake(this);
  /** Receives errors thrown by components; the other components continue. While null, `update` rethrows. */
  onComponentError: ((component: Component, error: unknown) => void) | null = null;
  /** Prefabs that objects of the scene are instances of. */
  readonly prefabs = new PrefabTable((id) => this.notify({ kind: 'prefab', id }));
  /** @internal */
  readonly childList: GameObject[] = [];
  /** Camera for pointer picking when another camera than the active one draws the picture; else null. */
  pointerCamera: ThreeCamera | null = null;

  private readonly index = new SceneIndex();
  private readonly systems = new SceneSystems(this);
  private readonly calls = new ComponentCalls(this, this.index);
  private readonly pointer = new ScenePointer(this, this.index);
  /** Components with simulated values, which are reset when the simulation ends. */
  private readonly simulatedOnes = new Set<Component>();
  private wasSimulated = false;
  private authored: AuthoredState | null = null;
  private readonly listeners = new Set<(change: SceneChange) => void>();
  private readonly ownsAssets: boolean;
  private currentCamera: CameraComponent | null = null;
  private ownName: string;
  private seconds = 0;
  private edits = 0;
  private readonly endAssets: () => void;

  constructor(options: SceneOptions = {}) {
    this.ownName = options.name ?? 'Scene';
    this.three.name = this.ownName;
    this.ownsAssets = !options.assets;
    this.assets = options.assets ?? new AssetLibrary();
    this.registry = options.registry ?? builtinComponents;
    this.settings = new SceneSettings(this.three, this.assets, (field, before) => {
      if (field === 'bakedLight') this.baked.update();
      this.notify({ kind: 'settings', field, before });
    });
    this.endAssets = this.assets.onChange((change) => {
      if (change.kind !== 'changed') return;
      const { asset, field, before } = change;
      this.notify({ kind: 'asset', asset, field, before });
    });
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

  /** Number of GameObjects in the whole tree. */
  get size(): number {
    return this.index.objectsById.size;
  }

  /**
   * All components of a class (or of one derived from it), or of a type name, active or not. One array, kept up to
   * date: it may be read in every frame. Its order is not that of the tree.
   */
  componentsOf<T extends Component>(type: ComponentClass<T>): readonly T[];
  componentsOf<T extends Component>(type: string): readonly T[];
  componentsOf(type: ComponentClass | string): readonly Component[] {
    return this.index.componentsOf(type);
  }

  /** Whether any active component handles key events. */
  get takesKeys(): boolean {
    return this.index.keyed.array.some((component) => component.isActive && component.listensTo?.('key') !== false);
  }

  /** Renderer effects that the scene's components need; one array, kept up to date. */
  get requiredEffects(): readonly RequiredEffect[] {
    return this.index.effects.array;
  }

  /**
   * The camera to draw with: the first one added, unless another was chosen; null when the scene has none.
   * @throws Error when set to a camera that is not in the scene
   */
  get activeCamera(): CameraComponent | null {
    return this.currentCamera;
  }

  set activeCamera(camera: CameraComponent | null) {
    if (camera && !this.index.cameras.has(camera))
      throw new Error('The active camera is not in the scene: add it first.');
    if (camera === this.currentCamera) return;
    this.currentCamera = camera;
    this.notify({ kind: 'active-camera' });
  }

  /** Simulated time in seconds. */
  get time(): number {
    return this.seconds;
  }

  /** Whether the scene was updated by more than 0 s since it was made or reset. */
  get isSimulated(): boolean {
    return this.wasSimulated;
  }

  /** Counter of edits; simulation does not change it. */
  get revision(): number {
    return this.edits;
  }

  /** The scene itself, as a container of objects. */
  get scene(): Scene {
    return this;
  }

  /** @internal Parent of the children's three objects. */
  get threeParent(): ThreeScene {
    return this.three;
  }

  /**
   * Moves an object, with its descendants, to the top of the scene's tree; its local transform is kept.
   * @throws Error naming a duplicate id or an unknown asset; nothing has changed then
   */
  add(gameObject: GameObject, index?: number): this {
    moveGameObject(gameObject, this, index, { keepWorld: false });
    return this;
  }

  /** Removes an object from the scene, at any depth of the tree; it keeps its ids and may be added again. */
  remove(gameObject: GameObject): this {
    if (gameObject.scene !== this)
      throw new Error(`'${shortText(gameObject.name)}' is not in the scene '${shortText(this.name)}': add it first.`);
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

  /**
   * Advances the time: starts new components, then calls `update` of active components, systems, and `lateUpdate`.
   * @param deltaSeconds - 0 or more
   */
  update(deltaSeconds: number): void {
    this.seconds += deltaSeconds;
    this.assets.surfaceTime.value = this.seconds;
    if (deltaSeconds > 0) {
      this.wasSimulated = true;
      this.calls.start();
      this.pointer.update();
    }
    this.calls.update(deltaSeconds, this.seconds);
    this.systems.update(deltaSeconds, this.seconds);
    this.calls.lateUpdate(deltaSeconds, this.seconds);
  }

  /** The system of a class, made on first use: see `SceneSystem`. */
  system<T extends SceneSystem>(type: SceneSystemClass<T>): T {
    return this.systems.get(type);
  }

  /** Whether an error has switched a script's component off, until the script changes or the scene is reset. */
  isSwitchedOff(component: Component): boolean {
    return this.index.switchedOff.has(component);
  }

  /**
   * Reports an error of a component to `onComponentError`. A script's component is switched off.
   * @throws the error itself while `onComponentError` is null
   */
  reportError(component: Component, error: unknown): void {
    if (scriptClasses.has(component.componentClass)) this.index.switchOff(component);
    if (!this.onComponentError) throw error;
    this.onComponentError(component, error);
  }

  /** @internal Called when a component begins to simulate a value. */
  noteSimulated(component: Component): void {
    this.simulatedOnes.add(component);
  }

  /** @internal Adds or removes one component that needs a renderer effect. */
  useEffect(effect: RequiredEffect, isUsed: boolean): void {
    this.index.countEffect(effect, isUsed ? 1 : -1);
  }

  /** Moves everything whose motion depends on time alone to `seconds`, with the same result in every run. */
  setTime(seconds: number): void {
    this.seconds = seconds;
    this.update(0);
  }

  /**
   * Records the scene's state for the next `reset`, which restores objects and components that were removed, disposed
   * of or moved, removes added ones, and restores names, flags and fields. Edits of scripts stay.
   */
  keepAuthored(): void {
    this.authored ??= new AuthoredState(this);
  }

  /**
   * @internal Called before an object is disposed of.
   * @returns true when `reset` restores the object, which is then only removed from the scene
   */
  holds(gameObject: GameObject): boolean {
    return this.authored?.hold(gameObject) ?? false;
  }

  /** Pauses the systems (sounds stop); the next `update` resumes them. */
  pause(): void {
    this.systems.pause();
  }

  /** Undoes simulation: time 0, and authored poses. After `keepAuthored`, all other changes since are undone too. */
  reset(): void {
    this.pointer.reset();
    this.calls.destroyAll();
    this.index.switchOn();
    this.authored?.restore();
    this.systems.reset();
    for (const component of this.simulatedOnes) component.endSimulation();
    this.simulatedOnes.clear();
    this.traverse((gameObject) => gameObject.transform.restoreAuthored());
    this.setTime(0);
    // `setTime` calls components, which may have written fields: they are restored again
    this.authored?.restore();
    this.authored = null;
    this.wasSimulated = false;
  }

  /** Calls a method of every component of the scene that has it. @returns how many received the call */
  callMethod(name: string, ...args: unknown[]): number {
    let receivers = 0;
    for (const root of [...this.childList]) receivers += root.callMethod(name, ...args);
    return receivers;
  }

  /** Dispatches a pointer event to every active component with a method for it, and to those under the pointer. */
  dispatchPointer(event: EnginePointerEvent): void {
    this.calls.pointer(event);
    this.pointer.handleEvent(event);
  }

  /** Dispatches a pointer event only to components of the object under the pointer. */
  dispatchObjectPointer(event: EnginePointerEvent): void {
    this.pointer.handleEvent(event);
  }

  /** Dispatches a key event to every active component that wants it. */
  dispatchKey(event: EngineKeyEvent): void {
    this.calls.key(event);
  }

  /** Calls `listener` after each edit of structure, fields or settings. @returns function that removes the listener */
  onChange(listener: (change: SceneChange) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /**
   * Calls `listener` whenever three has brought the world matrices of `three` up to date.
   * @returns a function that removes the listener
   */
  onMatricesUpdated(listener: () => void): () => void {
    return this.three.onMatricesUpdated(listener);
  }

  /** Releases the scene's resources. An AssetLibrary that was passed in stays, without the scene as user. */
  dispose(): void {
    this.listeners.clear();
    this.endAssets();
    const { authored } = this;
    this.authored = null;
    authored?.discard();
    for (const root of this.childList.toReversed()) root.dispose();
    this.systems.dispose();
    this.baked.dispose();
    this.settings.dispose();
    this.three.clear();
    if (this.ownsAssets) this.assets.dispose();
  }

  /** @internal Counts an edit and calls the listeners. */
  notify(change: SceneChange): void {
    this.edits++;
    this.authored?.note(change);
    for (const listener of this.listeners) listener(change);
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
    this.pointer.forget(gameObject);
    this.index.objectsById.delete(gameObject.id);
    gameObject.sceneOf = null;
  }

  /** @internal */
  componentEntered(component: Component): void {
    this.index.addComponent(component);
    component.onEnterScene(this);
    if (!this.currentCamera) this.currentCamera = this.index.cameras.array[0] ?? null;
  }

  /** @internal */
  componentLeaves(component: Component): void {
    this.calls.destroy(component);
    component.onLeaveScene(this);
    if (this.simulatedOnes.delete(component)) component.endSimulation();
    this.index.removeComponent(component);
    if (component === (this.currentCamera as Component | null))
      this.currentCamera = this.index.cameras.array[0] ?? null;
  }
}
