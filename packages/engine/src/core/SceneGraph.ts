import type { FieldTable, FieldValue, Vector3Tuple } from '@farol/editing/fields';
import type {
  Camera as ThreeCamera,
  Matrix4,
  Object3D,
  OrthographicCamera,
  PerspectiveCamera,
  Quaternion,
  Scene as ThreeScene,
  Vector3,
} from 'three';
import type { AssetLibrary } from '../assets/AssetLibrary';
import type { FieldAsset } from '../assets/FieldAsset';
import type { FieldOwner } from '../fields/FieldOwner';
import type { PrefabLink } from './Prefab';
import type { PrefabTable } from './PrefabTable';
import type { EngineKeyEvent, EnginePointerEvent } from './events';
import type { RequiredEffect } from './RequiredEffect';
import type { SceneMicroShaders } from './SceneMicroShaders';
import type { SceneViews } from './SceneViews';
import type { SceneSettings } from '../settings/SceneSettings';
import type { Vector3Input } from './toVector3';

/**
 * What scenes, GameObjects and components are to each other and to their users. Each of the three names the other two, so
 * their types are on this page, and their classes, in files of their own, import it instead of each other.
 */

/** What the registry, the menus and the file format know of a class of components. */
export interface ComponentClass<T extends Component = Component> {
  new (): T;
  /** Name in files and menus. */
  readonly typeName: string;
  readonly fields: FieldTable;
  /** Version of its form in files; raise it, and write `migrate`, whenever a field changes its name, meaning or default. */
  readonly version: number;
  /** At most one on a GameObject. */
  readonly unique: boolean;
  /** One line for the Add menu. */
  readonly help: string;
  /** The effect of the renderer that the component cannot be seen without, such as decals; null for none. */
  readonly effect: RequiredEffect | null;
  /**
   * Names of the methods that EventTriggers offer; null for all that the class and those it extends have, but for the ones
   * that the engine calls. Of built-in classes null is none.
   */
  readonly callable: readonly string[] | null;
  /** Brings field values written by an older version up to `version`. */
  migrate?(values: Record<string, unknown>, fromVersion: number): Record<string, unknown>;
}

/** What a component learns of a pointer over its object, or over one below it. */
export interface ObjectPointerEvent extends EnginePointerEvent {
  /** The object that is drawn under the pointer; of `onPointerOut` the one that was. */
  readonly target: GameObject;
  /** Where the pointer is on it, in the world (m). */
  readonly point: Vector3;
  /** From the camera to that point (m). */
  readonly distance: number;
  /** Keeps the event from the objects above the one that is called. */
  stopPropagation(): void;
}

/** Events that cost something to find out, and are found out only for components that want them. */
export type CostlyEvents = 'pointer' | 'key';

/**
 * A part of a GameObject that gives it an ability. Its fields are declared once (see `component`), and read by the
 * inspector, the file format, undo and the tests.
 */
export interface Component extends FieldOwner {
  /** Unique in its scene and kept in files; '' until the component has been on a GameObject. */
  readonly id: string;
  readonly componentClass: ComponentClass;
  readonly typeName: string;
  /** False switches the component off without taking it away. */
  enabled: boolean;
  /**
   * The GameObject that the component is on.
   * @throws Error when it is on none
   */
  readonly gameObject: GameObject;
  readonly isAttached: boolean;
  /** The scene of the GameObject, or null. */
  readonly scene: Scene | null;
  /** Enabled, on a GameObject that is active together with all its ancestors. */
  readonly isActive: boolean;

  /**
   * The scene began to play, or the component came into one that plays: called once, before its first `update`, in a frame
   * that takes time.
   */
  start?(): void;
  /** Called every frame that is simulated, after every `update`, animation and physics; what follows others belongs here. */
  lateUpdate?(deltaSeconds: number, time: number): void;
  /** A component that was started leaves the scene, or the scene is reset. */
  onDestroy?(): void;

  /** Pointer events over the canvas, while the object is active and the component enabled. */
  onPointerDown?(event: EnginePointerEvent): void;
  onPointerMove?(event: EnginePointerEvent): void;
  onPointerUp?(event: EnginePointerEvent): void;
  onPointerWheel?(event: EnginePointerEvent): void;
  onKeyDown?(event: EngineKeyEvent): void;
  onKeyUp?(event: EngineKeyEvent): void;

  /**
   * Pointer events on what is drawn of the object or of any below it: the nearest mesh under the pointer is called, then
   * the objects above it. Over and out come once, however the pointer goes from part to part; whether it is over something
   * is found out when it moves. A press and a release are of any button; a click is of the first one, pressed and released
   * over the same object, no more than 10 CSS pixels apart. Touch is over what it presses, until it is lifted.
   */
  onPointerOver?(event: ObjectPointerEvent): void;
  onPointerOut?(event: ObjectPointerEvent): void;
  onPointerPress?(event: ObjectPointerEvent): void;
  onPointerRelease?(event: ObjectPointerEvent): void;
  onPointerClick?(event: ObjectPointerEvent): void;
  /** Whether it wants events that it has methods for at present ('pointer': those on objects); it does when absent. */
  listensTo?(events: CostlyEvents): boolean;

  /** The component came onto a GameObject; `gameObject` is there, `scene` perhaps not. */
  onAttach(): void;
  /** The component is about to leave its GameObject. */
  onDetach(): void;
  /** The GameObject came into a scene, or the component came onto a GameObject of one. */
  onEnterScene(scene: Scene): void;
  /** The GameObject, or the component alone, is about to leave the scene. */
  onLeaveScene(scene: Scene): void;
  /** A field got another value, by hand or by code. Called only while attached. */
  onFieldChanged(name: string): void;
  /** `isActive` may have changed: the component was enabled or disabled, or an object above it was. */
  onActiveChanged(): void;
  /**
   * Called every frame that is simulated; only components that override it are visited.
   * @param deltaSeconds - 0 when the scene was put at a time
   * @param time - the scene's time in seconds
   */
  update(deltaSeconds: number, time: number): void;
  /** Gives back what the component holds. It cannot be used afterwards. */
  dispose(): void;
  /**
   * Shows a value as long as the scene plays, or until `endSimulation` or `set`: no edit, and not saved. `get` and the
   * property of the field answer with it. Of a Transform it moves the object.
   * @throws FieldError as `set` does
   */
  simulate(name: string, value: FieldValue): void;
  /** Shows every authored value again; `Scene.reset` does it for all components. */
  endSimulation(): void;
  /** Whether values are shown in place of authored ones. */
  readonly isSimulated: boolean;
  /** The authored value of every field; those that show a part of another one are left out. */
  authoredValues(): Record<string, FieldValue>;

  /** @internal Called by GameObject. */
  attachTo(gameObject: GameObject, id: string): void;
  /** @internal Called by GameObject. */
  detach(): void;
}

/** A component that a scene can be drawn through: `Camera`, or any other with these members. */
export interface CameraComponent extends Component {
  /** The camera to draw with, below the object's object3D. */
  readonly three: PerspectiveCamera | OrthographicCamera;
  /** Called before each frame with the size of the canvas, in any unit; not an edit. */
  setViewport(width: number, height: number): void;
}

/** Where a GameObject is; every GameObject has exactly one. See the class of this name. */
export interface Transform extends Component {
  /** Metres, relative to the parent. */
  position: Vector3Tuple;
  /** Radians about x, then y, then z, relative to the parent. */
  rotation: Vector3Tuple;
  /** Factor of size along the own axes. */
  scale: Vector3Tuple;
  /** The matrix from the object's space to the world's: a copy, up to date. */
  modelMatrix: Matrix4;
  /** Unit vector to the object's right (+X) in the world. */
  readonly right: Vector3;
  /** Unit vector to the object's top (+Y) in the world. */
  readonly top: Vector3;
  /** Unit vector to the object's front (-Z) in the world. */
  readonly front: Vector3;
  /** Where the object is in the world, in metres. */
  readonly worldPosition: Vector3;
  /** Puts the object back to where it was authored, undoing what simulation did. */
  restoreAuthored(): void;
  /** Moves by a vector along the axes of the world, in metres. */
  translate(offset: Vector3Input): void;
  /** Moves by a vector along the object's own axes, in metres of its parent's space (its scale does not count). */
  translateLocal(offset: Vector3Input): void;
  /** Turns about an axis of the world through the object's own place, by radians, anticlockwise seen against the axis. */
  rotate(radians: number, axis: Vector3Input): void;
  /** Turns about one of the object's own axes, by radians. */
  rotateLocal(radians: number, axis: Vector3Input): void;
  /** Turns the front to a point of the world. */
  lookAt(target: Vector3Input): void;
  /**
   * Puts the object at `eye` (in the world) and turns its front to `target`.
   * @param up - the direction that shall be its top, as far as it can; [0, 1, 0] when absent
   */
  lookAt(eye: Vector3Input, target: Vector3Input, up?: Vector3Input): void;
  /** Sets the rotation from a quaternion relative to the parent. */
  setQuaternion(value: Quaternion): void;
}

/** What is left of a component without its class. */
export interface ComponentData {
  readonly type: string;
  /** Version of the class that wrote the values. */
  readonly version: number;
  readonly values: Readonly<Record<string, FieldValue>>;
}

/** The types of components that files and menus may name. */
export interface ComponentRegistry {
  /** Whether files may hold components of types that nobody registered. */
  readonly keepsUnknown: boolean;
  /** Every type by its name, in the order of registration. */
  readonly types: ReadonlyMap<string, ComponentClass>;
  /** Adds a type. @throws Error when it has no name, or the name is another class's */
  register(componentClass: ComponentClass): this;
  /** Takes a type out: no more of it can be added by name. Components of it that there are stay what they are. */
  unregister(componentClass: ComponentClass): void;
  /** The fields of a type; none of one that is not known, where those are kept. @throws Error for one that is refused */
  fieldsOf(typeName: string): FieldTable;
  /** @throws Error naming the types that there are */
  get(typeName: string): ComponentClass;
  /**
   * A component on no object from the data of a checked file. Where types that are not known are kept, one of them too, and
   * values that the class, whose script has changed, does not have or allow are left out.
   */
  createFrom(data: ComponentData): Component;
  /** A new component on no object. @throws Error for an unknown type, FieldError for a wrong value */
  create(typeName: string, values?: Readonly<Record<string, FieldValue>>): Component;
}

/** What can hold GameObjects: another one, or a scene. */
export interface GameObjectContainer {
  /** @internal */
  readonly childList: GameObject[];
  /** The scene that it is, or is in. */
  readonly scene: Scene | null;
  /** @internal The three object below which its children's hang. */
  readonly threeParent: Object3D;
}

/** How a component is put on a GameObject. */
export interface AddComponentOptions {
  /** Place among the components; at the end when absent. Place 0 is the Transform's. */
  index?: number;
  /** Id in place of one made from the object's. */
  id?: string;
  enabled?: boolean;
}

export interface MoveOptions {
  /** Keep position, rotation and scale in the world. */
  keepWorld?: boolean;
}

/**
 * A thing of the scene. By itself it does nothing: it holds children and components, and passes updates, events and
 * calls on to them. It owns one three object, `object3D`; its front is that object's -Z axis.
 */
export interface GameObject extends GameObjectContainer {
  readonly id: string;
  readonly object3D: Object3D;
  /** Always there, always the first component. */
  readonly transform: Transform;
  name: string;
  tags: readonly string[];
  /** The object of a prefab that this one is a copy of; null for an object of its own. */
  prefabLink: PrefabLink | null;
  /** False hides the object and its children, and stops their updates and events. */
  active: boolean;
  /** Whether an editor leaves the object and all below it alone: they are not picked in the picture. It has no other effect. */
  locked: boolean;
  /** Whether the object stays where it is: a bake gives what it draws a lightmap. What is below it has a flag of its own. */
  isStatic: boolean;
  /** Locked, or below an object that is. */
  readonly lockedInHierarchy: boolean;
  /** Active, and so are all its ancestors. */
  readonly activeInHierarchy: boolean;
  readonly parent: GameObject | null;
  readonly children: readonly GameObject[];
  readonly components: readonly Component[];

  /** Adds a child, or moves one that is elsewhere; its local transform stays. @throws Error for a cycle */
  add(child: GameObject, index?: number): this;
  /** Takes a child out, with all below it; it may be added again. @throws Error when it is no child of this object */
  remove(child: GameObject): this;
  /**
   * Moves the object below another, or to the top of a scene.
   * @param index - place among the new siblings; at the end when absent
   * @param options - `keepWorld` (default true): it stays where it is in the world. Under a parent with unequal scales
   * a rotated object would need shear, which a Transform cannot hold: it then comes as near as it can.
   * @throws Error when the new parent is the object itself or below it; nothing has changed then
   */
  reparent(parent: GameObject | Scene, index?: number, options?: MoveOptions): void;
  /**
   * Puts a component on the object.
   * @param type - class, type name, or a component that is on no object
   * @param values - field values in place of the defaults
   * @throws Error for an unknown type name or a second component of a unique type; FieldError for a wrong value
   */
  addComponent<T extends Component>(
    type: ComponentClass<T> | T,
    values?: Readonly<Record<string, FieldValue>>,
    options?: AddComponentOptions,
  ): T;
  addComponent(type: string, values?: Readonly<Record<string, FieldValue>>, options?: AddComponentOptions): Component;
  /** Takes a component off; it may be added again, or disposed. @throws Error for the Transform or a stranger */
  removeComponent(component: Component): void;
  /** Moves a component to another place in the list; the Transform stays first. */
  moveComponent(component: Component, index: number): void;
  /** The first component of a class (or of one derived from it), or of a type name; null when there is none. */
  getComponent<T extends Component>(type: ComponentClass<T>): T | null;
  getComponent(type: string): Component | null;
  /** All components of a class, or of a type name. */
  getComponents<T extends Component>(type: ComponentClass<T>): T[];
  getComponents(type: string): Component[];
  /** Updates its active components, then its children. A Scene does the same from flat lists. */
  update(deltaSeconds: number, time: number): void;
  /**
   * Calls a method of every component that has it, here and in all children (thesis 3.2.4), active or not.
   * @returns how many components received the call
   */
  callMethod(name: string, ...args: unknown[]): number;
  /** Visits the object and all below it, parents first. */
  traverse(visit: (gameObject: GameObject) => void): void;
  /** The first object with this id, else with this name, among this one and all below it; null when there is none. */
  find(nameOrId: string): GameObject | null;
  /**
   * A copy with all below it, with new ids, in no scene. References to objects inside the copy follow it. A whole
   * instance of a prefab is copied as one; a part of one becomes an object of its own.
   */
  clone(): GameObject;
  /** Takes the object out of its parent or scene, and gives back what it and all below it hold. */
  dispose(): void;

  /** @internal What it is directly in. */
  container: GameObjectContainer | null;
  /** @internal */
  sceneOf: Scene | null;
  /** @internal Called when `active` changed here or above. */
  refreshActive(): void;
}

/** What an edit changed. Simulation makes none of these. */
export type SceneChange =
  | { readonly kind: 'add' | 'remove' | 'move'; readonly gameObject: GameObject }
  | {
      readonly kind: 'object';
      readonly gameObject: GameObject;
      readonly property: 'name' | 'active' | 'locked' | 'static' | 'tags' | 'prefab';
    }
  | {
      /** `component-class`: the component has become one of another class, by a script that was edited. */
      readonly kind: 'component-add' | 'component-remove' | 'component-move' | 'component-class';
      readonly gameObject: GameObject;
      readonly component: Component;
    }
  | {
      readonly kind: 'field';
      readonly component: Component;
      readonly field: string;
      /** The authored value until then. */
      readonly before: FieldValue;
    }
  | { readonly kind: 'enabled'; readonly component: Component }
  | { readonly kind: 'settings'; readonly field: string; readonly before: FieldValue }
  | {
      /** Of an asset of the library that is made of fields. */
      readonly kind: 'asset';
      readonly asset: FieldAsset;
      readonly field: string;
      readonly before: FieldValue;
    }
  | { readonly kind: 'microshader'; readonly name: string }
  | { readonly kind: 'view'; readonly place: number }
  | { readonly kind: 'prefab'; readonly id: string }
  | { readonly kind: 'active-camera' | 'name' };

/** The baked light of a scene, by its setting `bakedLight`; what shows it comes with the asset. */
export interface SceneBake {
  /** Whether the scene is lit by it. */
  readonly isShown: boolean;
  /** Takes the baked light off the scene while light is baked anew. @returns a function that ends it */
  suspend(): () => void;
  /** @internal Whether a light is in lightmaps and probes, and is not drawn. @param light - id of the component */
  hides(light: string): boolean;
  /** @internal Gives the meshes of a component their lightmaps. @param component - its id */
  dress(component: string, root: Object3D): void;
  /** @internal Gives meshes that leave the scene back what they had. */
  undress(root: Object3D): void;
}

/** What lights a scene by lightmaps and probes. */
export interface ShownLight {
  /** Whether all light of a Light is in it. @param light - id of the component */
  hides(light: string): boolean;
  /** Gives the meshes below `root`, which a component draws, their lightmaps. @param component - its id */
  dress(component: string, root: Object3D): void;
  /** Gives the meshes below `root` back what they had. */
  undress(root: Object3D): void;
  /** Leaves the scene as it is without it. */
  end(): void;
}

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

/** A world of GameObjects over one three scene. Any number may exist. */
export interface Scene extends GameObjectContainer {
  /** Itself. */
  readonly scene: Scene;
  readonly three: ThreeScene;
  readonly assets: AssetLibrary;
  /** Known types of components. */
  registry: ComponentRegistry;
  readonly settings: SceneSettings;
  /** Microshaders that are saved with the scene. */
  readonly microShaders: SceneMicroShaders;
  /** Views that editors keep with the scene. */
  readonly views: SceneViews;
  /** Light of the scene that was baked. */
  readonly baked: SceneBake;
  /** What objects of the scene are copies of. */
  readonly prefabs: PrefabTable;
  /** Takes what a component throws while it is updated; the others go on. While null, `update` throws it. */
  onComponentError: ((component: Component, error: unknown) => void) | null;
  name: string;
  readonly roots: readonly GameObject[];
  /** How many objects it has, however deep in the tree. */
  readonly size: number;
  /** Whether a component that is active listens to keys. */
  readonly takesKeys: boolean;
  /** The effects of the renderer that components of the scene need; the same array all along. */
  readonly requiredEffects: readonly RequiredEffect[];
  /**
   * The camera to draw with: the first one that came, unless another was chosen; null when the scene has none.
   * @throws Error when set to a camera that is not in the scene
   */
  activeCamera: CameraComponent | null;
  /** What the picture is seen through, where that is not the active camera: pointer events on objects go by it. */
  pointerCamera: ThreeCamera | null;
  /** Simulated time in seconds. */
  readonly time: number;
  /** Whether it was updated by more than 0 seconds since it was made or reset. */
  readonly isSimulated: boolean;
  /** Grows by one with each edit; simulation leaves it as it is. */
  readonly revision: number;

  /**
   * Every component of a class (or of one derived from it), or of a type name, active or not. The array is the same one all
   * along, kept up to date as components come and go: it may be read in every frame. Its order is not that of the tree.
   */
  componentsOf<T extends Component>(type: ComponentClass<T>): readonly T[];
  componentsOf<T extends Component>(type: string): readonly T[];
  /**
   * Adds an object, with all below it, at the top of the tree; out of wherever it was, its local transform kept.
   * @throws Error naming a duplicate id or an unknown asset; nothing has changed then
   */
  add(gameObject: GameObject, index?: number): this;
  /** Takes an object out of the scene, wherever in the tree it is; it keeps its ids and may be added again. */
  remove(gameObject: GameObject): this;
  /** The object with this id, else the first with this name in tree order; null when there is none. */
  find(nameOrId: string): GameObject | null;
  findById(id: string): GameObject | null;
  findComponentById(id: string): Component | null;
  /** Visits every object, parents first, in tree order. */
  traverse(visit: (gameObject: GameObject) => void): void;
  /** The system of a class, made when it is first asked for: see `SceneSystem`. */
  system<T extends SceneSystem>(type: SceneSystemClass<T>): T;
  /**
   * Whether a component of a script is left alone since it threw: it is not called until it is changed, or the scene is reset.
   * Its `enabled` stays as it is.
   */
  isSwitchedOff(component: Component): boolean;
  /**
   * Tells of something that a component threw: to `onComponentError`. A component of a script is switched off.
   * @throws what it was given while that is null
   */
  reportError(component: Component, error: unknown): void;
  /** Advances the time; starts, then updates every active component that wants it, then the systems, then `lateUpdate`. @param deltaSeconds - 0 or more */
  update(deltaSeconds: number): void;
  /** Puts everything whose motion depends on time alone at `seconds`: the same in every run. */
  setTime(seconds: number): void;
  /**
   * Undoes simulation: time 0, and every object where it was authored. After `keepAuthored` all else that was changed since
   * is taken back too.
   */
  reset(): void;
  /**
   * From now on the scene remembers what it is made of, until the next `reset`: that brings back objects and components that
   * were removed, disposed of or moved, takes out those that were added, and sets names, switches and fields as they are now.
   * Scripts that are edited meanwhile stay as they are edited.
   */
  keepAuthored(): void;
  /** Calls a method of every component of the scene that has it. @returns how many received the call */
  callMethod(name: string, ...args: unknown[]): number;
  /** Tells the systems that the simulation is held: sounds pause. The next `update` lets them go on. */
  pause(): void;
  /** Passes a pointer event on to every active component that wants it, and to those of the object under the pointer. */
  dispatchPointer(event: EnginePointerEvent): void;
  /** Passes a pointer event on to the components of the object under the pointer alone. */
  dispatchObjectPointer(event: EnginePointerEvent): void;
  /** Passes a key event on to every active component that wants it. */
  dispatchKey(event: EngineKeyEvent): void;
  /** Calls `listener` after each edit of structure, fields or settings. @returns a function that ends it */
  onChange(listener: (change: SceneChange) => void): () => void;
  /** Calls `listener` whenever three has brought the world matrices of `three` up to date. @returns a function that ends it */
  onMatricesUpdated(listener: () => void): () => void;
  /** Gives back all that the scene holds. An AssetLibrary that was passed in stays, with what this scene used released. */
  dispose(): void;

  /** @internal An object is about to be disposed of. @returns whether it has only left the scene, since `reset` brings it back */
  holds(gameObject: GameObject): boolean;
  /** @internal A component shows a value that was not authored. */
  noteSimulated(component: Component): void;
  /** @internal Something of the scene needs an effect of the renderer, or needs it no more. */
  useEffect(effect: RequiredEffect, isUsed: boolean): void;
  /** @internal Counts an edit and tells the listeners. */
  notify(change: SceneChange): void;
  /** @internal @throws Error when an object cannot come in */
  checkSubtree(gameObject: GameObject): void;
  /** @internal @throws Error when a component names an asset that nobody knows */
  checkComponent(component: Component): void;
  /** @internal */
  subtreeEntered(gameObject: GameObject): void;
  /** @internal */
  subtreeLeaves(gameObject: GameObject): void;
  /** @internal */
  componentEntered(component: Component): void;
  /** @internal */
  componentLeaves(component: Component): void;
}
