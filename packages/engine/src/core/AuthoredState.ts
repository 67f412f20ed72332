import { currentOf, replaceOwner } from '@farol/editing';
import type { FieldValue } from '@farol/editing/fields';
import type { Prefab } from './Prefab';
import type { FieldOwner } from '../fields/FieldOwner';
import { moveGameObject } from './moveGameObject';
import { scriptClasses } from './scriptClasses';
import type { CameraComponent } from './CameraComponent';
import type { Component } from './Component';
import type { GameObject } from './GameObject';
import type { GameObjectContainer } from './GameObjectContainer';
import type { Scene } from './Scene';
import type { SceneChange } from './SceneChange';
import type { SceneView } from './SceneViews';

interface ComponentRecord {
  readonly component: Component;
  readonly id: string;
  readonly enabled: boolean;
}

interface ObjectRecord {
  readonly children: readonly GameObject[];
  readonly components: readonly ComponentRecord[];
  readonly name: string;
  readonly active: boolean;
  readonly locked: boolean;
  readonly isStatic: boolean;
  readonly tags: readonly string[];
  readonly prefabLink: GameObject['prefabLink'];
}

const recordOf = (object: GameObject): ObjectRecord => ({
  children: [...object.children],
  components: object.components.map((component) => ({ component, id: component.id, enabled: component.enabled })),
  name: object.name,
  active: object.active,
  locked: object.locked,
  isStatic: object.isStatic,
  tags: object.tags,
  prefabLink: object.prefabLink,
});

/** Whether `restore` keeps edits of assets of a type: true for scripts and surfaces, whose text users type. */
const staysAsTyped = (type: string): boolean => type === 'script' || type === 'surface';

/**
 * State of a scene at a moment, from which all later changes by code can be undone: added, removed and moved objects
 * and components, names, flags (`active`, `enabled`, …) and fields. Edits of scripts are not undone.
 */
export class AuthoredState {
  private readonly objects = new Map<GameObject, ObjectRecord>();
  private readonly roots: readonly GameObject[];
  private readonly camera: CameraComponent | null;
  private readonly name: string;
  private readonly views: readonly (readonly [number, SceneView])[];
  private readonly microShaders: ReadonlyMap<string, string>;
  private readonly prefabs: readonly Prefab[];
  private readonly assets: ReadonlySet<string>;
  /** Values of changed fields from before their first change, by owner and field name. */
  private readonly fields = new Map<FieldOwner, Map<string, FieldValue>>();
  /** Whether anything but field values was changed since the state was recorded or last restored. */
  private isTouched = false;
  private isRestoring = false;

  constructor(private readonly scene: Scene) {
    scene.traverse((object) => this.objects.set(object, recordOf(object)));
    this.roots = [...scene.roots];
    this.camera = scene.activeCamera;
    this.name = scene.name;
    this.views = scene.views.entries;
    this.microShaders = new Map(scene.microShaders.texts);
    this.prefabs = scene.prefabs.list;
    this.assets = new Set(scene.assets.fieldAssets().map(({ name }) => name));
  }

  /** Records a change of the scene. */
  note(change: SceneChange): void {
    if (this.isRestoring) return;
    if (change.kind === 'field') this.noteField(change.component, change.field, change.before);
    else if (change.kind === 'settings') this.noteField(this.scene.settings, change.field, change.before);
    else if (change.kind === 'asset') {
      if (!staysAsTyped(change.asset.type)) this.noteField(change.asset, change.field, change.before);
    } else {
      this.isTouched = true;
      // a removed object reports no further field changes, so all its values are recorded now
      if (change.kind === 'remove') change.gameObject.traverse(({ components }) => components.forEach(this.noteAll));
      else if (change.kind === 'component-remove') this.noteAll(change.component);
    }
  }

  /**
   * Called before an object is disposed of. If the object, or else descendants of it, are part of the recorded state,
   * they are only removed from the scene, so that `restore` can add them again.
   * @returns whether the object itself is in the recorded state
   */
  hold(gameObject: GameObject): boolean {
    if (this.objects.has(gameObject)) {
      moveGameObject(gameObject, null);
      return true;
    }
    const held: GameObject[] = [];
    gameObject.traverse((each) => {
      if (this.objects.has(each)) held.push(each);
    });
    for (const each of held) if (each.container && !this.isBelow(each, held)) moveGameObject(each, null);
    return false;
  }

  /** Restores the recorded state. Callable repeatedly; each call undoes the changes since the last call. */
  restore(): void {
    this.isRestoring = true;
    try {
      if (this.isTouched) this.restoreStructure();
      // a replaced component's recorded values are older than those of its replacement: set last, they win
      for (const [noted, values] of [...this.fields].toReversed()) {
        const owner = currentOf(noted);
        for (const [name, value] of values) if (Object.hasOwn(owner.fields, name)) trySet(owner, name, value);
      }
      this.isTouched = false;
    } finally {
      this.isRestoring = false;
    }
  }

  /** Disposes of objects that `hold` kept and that are not in the scene. */
  discard(): void {
    for (const object of this.objects.keys()) if (!object.scene && !object.container) object.dispose();
  }

  private readonly noteAll = (component: Component): void => {
    for (const [name, { viewOf }] of Object.entries(component.fields))
      if (viewOf === undefined) this.noteField(component, name, component.getAuthored(name));
  };

  private noteField(owner: FieldOwner, name: string, before: FieldValue): void {
    let values = this.fields.get(owner);
    if (!values) this.fields.set(owner, (values = new Map()));
    if (!values.has(name)) values.set(name, before);
  }

  private isBelow(object: GameObject, others: readonly GameObject[]): boolean {
    for (let above = object.parent; above; above = above.parent) if (others.includes(above)) return true;
    return false;
  }

  private restoreStructure(): void {
    const { scene } = this;
    const added: GameObject[] = [];
    const arrange = (container: GameObjectContainer, children: readonly GameObject[]): void => {
      children.forEach((child, i) => {
        if (container.childList[i] !== child) moveGameObject(child, container, i);
      });
      added.push(...container.childList.slice(children.length));
    };
    // parents first: if an object was moved below its own child, it must leave the child before the child is put back
    arrange(scene, this.roots);
    for (const [object, { children }] of this.objects) arrange(object, children);
    // `added` also has recorded objects that were found below another parent; only new objects are disposed of
    for (const each of added) if (!this.objects.has(each)) each.dispose();
    for (const [object, record] of this.objects) this.restoreObject(object, record);
    for (const asset of scene.assets.fieldAssets()) {
      if (!staysAsTyped(asset.type) && !this.assets.has(asset.name)) scene.assets.unregister(asset.name);
    }
    scene.name = this.name;
    for (const [place] of scene.views.entries)
      if (!this.views.some(([at]) => at === place)) scene.views.set(place, null);
    for (const [place, view] of this.views) scene.views.set(place, view);
    for (const name of [...scene.microShaders.texts.keys()]) {
      if (!this.microShaders.has(name)) scene.microShaders.set(name, null);
    }
    for (const [name, text] of this.microShaders) scene.microShaders.set(name, text);
    for (const { id } of scene.prefabs.list) if (!this.prefabs.some((each) => each.id === id)) scene.prefabs.delete(id);
    for (const prefab of this.prefabs) scene.prefabs.set(prefab);
    const camera = this.camera && currentOf(this.camera);
    if (scene.activeCamera !== camera && camera?.scene === scene) scene.activeCamera = camera;
  }

  private restoreObject(object: GameObject, record: ObjectRecord): void {
    const wanted = new Set(record.components.map(({ component }) => currentOf(component)));
    for (const component of [...object.components]) {
      if (wanted.has(component)) continue;
      object.removeComponent(component);
      component.dispose();
    }
    record.components.forEach(({ component: recorded, id, enabled }, index) => {
      const component = currentOf(recorded);
      if (object.components[index] === component) component.enabled = enabled;
      else if (component.isAttached && component.gameObject === object) object.moveComponent(component, index);
      else {
        if (component.isAttached) component.gameObject.removeComponent(component);
        // a new component, as the old one may be disposed of; a script's is used again: recompiling replaces it anyway
        const placed = scriptClasses.has(component.componentClass) ? component : new component.componentClass();
        if (placed !== component) replaceOwner(component, placed);
        for (const [name, value] of this.fields.get(component) ?? []) trySet(placed, name, value);
        object.addComponent(placed, {}, { index, id, enabled });
      }
      currentOf(component).enabled = enabled;
    });
    const { name, active, locked, isStatic, tags, prefabLink } = record;
    object.name = name;
    object.active = active;
    object.locked = locked;
    object.isStatic = isStatic;
    if (object.tags !== tags) object.tags = tags;
    object.prefabLink = prefabLink;
  }
}

/** Sets a field if the class still accepts it: an edited script may have changed the field. */
function trySet(owner: FieldOwner, name: string, value: FieldValue): void {
  try {
    owner.set(name, value);
  } catch (error) {
    console.error(error);
  }
}
