import { shortText } from '@farol/editing';
import type { Camera as ThreeCamera, Scene as ThreeScene } from 'three';
import { AssetLibrary } from '../assets/AssetLibrary';
import { assetFields } from '../fields/assetFields';
import { PrefabTable } from './PrefabTable';
import { AuthoredState } from './AuthoredState';
import { builtinComponents } from './builtinComponents';
import type { EngineKeyEvent, EnginePointerEvent } from './events';
import { moveGameObject } from './moveGameObject';
import type { RequiredEffect } from './RequiredEffect';
import type {
  CameraComponent,
  Component,
  ComponentClass,
  ComponentRegistry,
  GameObject,
  Scene as SceneType,
  SceneChange,
  SceneSystem,
  SceneSystemClass,
} from './SceneGraph';
import { SceneIndex } from './SceneIndex';
import { ScenePointer } from './ScenePointer';
import { scriptClasses } from './scriptClasses';
import { SceneBake } from './baked/SceneBake';
import { SceneMicroShaders } from './SceneMicroShaders';
import { SceneSystems } from './SceneSystems';
import { SceneViews } from './SceneViews';
import { SceneRoot } from './SceneRoot';
import { SceneSettings } from '../settings/SceneSettings';

export interface SceneOptions {
  name?: string;
  /** Where meshes and textures come from. A library of its own, disposed with the scene, when absent. */
  assets?: AssetLibrary;
  /** Known types of components; the built-in ones when absent. */
  registry?: ComponentRegistry;
}

/** See the interface. */
class BaseScene implements SceneType {
  readonly three = new SceneRoot();
  readonly assets: AssetLibrary;
  /** Types of components that can be added by name: by files, prefabs and menus. Another one must have those in use. */
  registry: ComponentRegistry;
  readonly settings: SceneSettings;
  readonly microShaders = new SceneMicroShaders((name) => this.notify({ kind: 'microshader', name }));
  readonly views = new SceneViews((place) => this.notify({ kind: 'view', place }));
  readonly baked: SceneBake = new SceneBake(this);
  onComponentError: ((component: Component, error: unknown) => void) | null = null;
  readonly prefabs = new PrefabTable((id) => this.notify({ kind: 'prefab', id }));
  readonly childList: GameObject[] = [];
  pointerCamera: ThreeCamera | null = null;

  private readonly index = new SceneIndex();
  private readonly systems = new SceneSystems(this);
  private readonly pointer = new ScenePointer(this, this.index);
  /** Components that show values which were not authored. */
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

  get size(): number {
    return this.index.objectsById.size;
  }

  componentsOf<T extends Component>(type: ComponentClass<T>): readonly T[];
  componentsOf<T extends Component>(type: string): readonly T[];
  componentsOf(type: ComponentClass | string): readonly Component[] {
    return this.index.componentsOf(type);
  }

  get takesKeys(): boolean {
    return this.index.keyed.array.some((component) => component.isActive && component.listensTo?.('key') !== false);
  }

  get requiredEffects(): readonly RequiredEffect[] {
    return this.index.effects.array;
  }

  get activeCamera(): CameraComponent | null {
    return this.currentCamera;
  }

  set activeCamera(camera: CameraComponent | null) {
    if (camera && !this.index.cameras.has(camera))
      throw new Error('The active camera must be in the scene: add it first.');
    if (camera === this.currentCamera) return;
    this.currentCamera = camera;
    this.notify({ kind: 'active-camera' });
  }

  get time(): number {
    return this.seconds;
  }

  get isSimulated(): boolean {
    return this.wasSimulated;
  }

  get revision(): number {
    return this.edits;
  }

  get scene(): Scene {
    return this;
  }

  get threeParent(): ThreeScene {
    return this.three;
  }

  add(gameObject: GameObject, index?: number): this {
    moveGameObject(gameObject, this, index, { keepWorld: false });
    return this;
  }

  remove(gameObject: GameObject): this {
    if (gameObject.scene !== this)
      throw new Error(`'${shortText(gameObject.name)}' is not in the scene '${shortText(this.name)}'.`);
    moveGameObject(gameObject, null, undefined, { keepWorld: false });
    return this;
  }

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

  traverse(visit: (gameObject: GameObject) => void): void {
    for (const root of this.childList) root.traverse(visit);
  }

  update(deltaSeconds: number): void {
    this.seconds += deltaSeconds;
    this.assets.surfaceTime.value = this.seconds;
    if (deltaSeconds > 0) {
      this.wasSimulated = true;
      this.startWaiting();
      this.pointer.update();
    }
    const updated = this.index.updated.array;
    for (let i = 0; i < updated.length; i++) {
      const component = updated[i];
      if (!component.isActive || this.isTooEarly(component, deltaSeconds)) continue;
      try {
        component.update(deltaSeconds, this.seconds);
      } catch (error) {
        this.reportError(component, error);
      }
      // the last one comes to the place of one that is switched off or leaves
      if (updated[i] !== component) i--;
    }
    this.systems.update(deltaSeconds, this.seconds);
    const late = this.index.late.array;
    for (let i = 0; i < late.length; i++) {
      const component = late[i];
      if (!component.isActive || this.isTooEarly(component, deltaSeconds)) continue;
      try {
        component.lateUpdate!(deltaSeconds, this.seconds);
      } catch (error) {
        this.reportError(component, error);
      }
      if (late[i] !== component) i--;
    }
  }

  system<T extends SceneSystem>(type: SceneSystemClass<T>): T {
    return this.systems.get(type);
  }

  isSwitchedOff(component: Component): boolean {
    return this.index.switchedOff.has(component);
  }

  reportError(component: Component, error: unknown): void {
    if (scriptClasses.has(component.componentClass)) this.index.switchOff(component);
    if (!this.onComponentError) throw error;
    this.onComponentError(component, error);
  }

  noteSimulated(component: Component): void {
    this.simulatedOnes.add(component);
  }

  useEffect(effect: RequiredEffect, isUsed: boolean): void {
    this.index.countEffect(effect, isUsed ? 1 : -1);
  }

  setTime(seconds: number): void {
    this.seconds = seconds;
    this.update(0);
  }

  keepAuthored(): void {
    this.authored ??= new AuthoredState(this);
  }

  holds(gameObject: GameObject): boolean {
    return this.authored?.hold(gameObject) ?? false;
  }

  pause(): void {
    this.systems.pause();
  }

  reset(): void {
    this.pointer.reset();
    for (const component of [...this.index.started.array]) this.destroyed(component);
    this.index.switchOn();
    this.authored?.restore();
    this.systems.reset();
    for (const component of this.simulatedOnes) component.endSimulation();
    this.simulatedOnes.clear();
    this.traverse((gameObject) => gameObject.transform.restoreAuthored());
    this.setTime(0);
    // components may write fields at time 0 too
    this.authored?.restore();
    this.authored = null;
    this.wasSimulated = false;
  }

  /** Whether a component is not to be updated yet: it came in this frame and starts in the next one, or is of a script that does not run. */
  private isTooEarly(component: Component, deltaSeconds: number): boolean {
    if (deltaSeconds === 0) return scriptClasses.has(component.componentClass);
    const { waiting } = this.index;
    return waiting.array.length > 0 && waiting.has(component);
  }

  /** Starts every active component that was not started yet; those that their `start` brings are started too. */
  private startWaiting(): void {
    const { waiting, started } = this.index;
    for (let i = 0; i < waiting.array.length;) {
      const component = waiting.array[i];
      if (!component.isActive) {
        i++;
        continue;
      }
      // the last one comes to place i
      waiting.remove(component);
      started.add(component);
      try {
        component.start?.();
      } catch (error) {
        this.reportError(component, error);
      }
    }
  }

  private destroyed(component: Component): void {
    this.index.started.remove(component);
    this.index.waiting.add(component);
    try {
      component.onDestroy?.();
    } catch (error) {
      this.reportError(component, error);
    }
  }

  callMethod(name: string, ...args: unknown[]): number {
    let receivers = 0;
    for (const root of [...this.childList]) receivers += root.callMethod(name, ...args);
    return receivers;
  }

  dispatchPointer(event: EnginePointerEvent): void {
    const components = this.index.pointed.array;
    for (let i = 0; i < components.length; i++) {
      const component = components[i];
      if (!component.isActive) continue;
      try {
        if (event.type === 'move') component.onPointerMove?.(event);
        else if (event.type === 'down') component.onPointerDown?.(event);
        else if (event.type === 'up') component.onPointerUp?.(event);
        else if (event.type === 'wheel') component.onPointerWheel?.(event);
      } catch (error) {
        this.reportError(component, error);
      }
      if (components[i] !== component) i--;
    }
    this.pointer.take(event);
  }

  dispatchObjectPointer(event: EnginePointerEvent): void {
    this.pointer.take(event);
  }

  dispatchKey(event: EngineKeyEvent): void {
    const components = this.index.keyed.array;
    for (let i = 0; i < components.length; i++) {
      const component = components[i];
      if (!component.isActive) continue;
      try {
        if (event.type === 'down') component.onKeyDown?.(event);
        else component.onKeyUp?.(event);
      } catch (error) {
        this.reportError(component, error);
      }
      if (components[i] !== component) i--;
    }
  }

  onChange(listener: (change: SceneChange) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  onMatricesUpdated(listener: () => void): () => void {
    return this.three.onMatricesUpdated(listener);
  }

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

  notify(change: SceneChange): void {
    this.edits++;
    this.authored?.note(change);
    for (const listener of this.listeners) listener(change);
  }

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

  checkComponent(component: Component): void {
    for (const { name, assetType } of assetFields(component.fields)) {
      const value = component.getAuthored(name);
      const problem = typeof value === 'string' && this.assets.problemWith(assetType, value);
      if (problem) throw new Error(`${component.typeName}.${name} ${problem}`);
    }
  }

  subtreeEntered(gameObject: GameObject): void {
    gameObject.sceneOf = this;
    this.index.objectsById.set(gameObject.id, gameObject);
    for (const component of gameObject.components) this.componentEntered(component);
    for (const child of gameObject.children) this.subtreeEntered(child);
  }

  subtreeLeaves(gameObject: GameObject): void {
    for (const child of gameObject.children) this.subtreeLeaves(child);
    for (const component of gameObject.components) this.componentLeaves(component);
    this.pointer.forget(gameObject);
    this.index.objectsById.delete(gameObject.id);
    gameObject.sceneOf = null;
  }

  componentEntered(component: Component): void {
    this.index.addComponent(component);
    component.onEnterScene(this);
    if (!this.currentCamera) this.currentCamera = this.index.cameras.array[0] ?? null;
  }

  componentLeaves(component: Component): void {
    if (this.index.started.has(component)) this.destroyed(component);
    component.onLeaveScene(this);
    if (this.simulatedOnes.delete(component)) component.endSimulation();
    this.index.removeComponent(component);
    if (component === (this.currentCamera as Component | null))
      this.currentCamera = this.index.cameras.array[0] ?? null;
  }
}

export type Scene = SceneType;

export const Scene: new (options?: SceneOptions) => Scene = BaseScene;
