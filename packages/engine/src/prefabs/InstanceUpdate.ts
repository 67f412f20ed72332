import { sameValue } from '@farol/editing/fields';
import type { ComponentRegistry } from '../core/ComponentRegistry';
import type { Component } from '../core/Component';
import type { GameObject } from '../core/GameObject';
import type { FileComponent, FileObject } from '../files/FarolFile';
import { mapReferences } from './copyObjects';
import { isOwnOfInstance, keyOf, objectsBySource } from './instances';
import { instantiatePrefab } from './instantiatePrefab';
import type { Prefab } from '../core/Prefab';
import { comparedFields, componentsOf, objectsOf, valueIn } from './prefabData';
import type { PrefabEdit } from './PrefabEdit';

const sameTags = (a: readonly string[] = [], b: readonly string[] = []): boolean =>
  a.length === b.length && a.every((tag, i) => tag === b[i]);

/**
 * Computes the edits of an instance when its prefab is replaced: a three-way merge by object and field. A value that
 * equals the old prefab's is replaced by the new prefab's; any other value is an override and is kept.
 */
export class InstanceUpdate {
  readonly edits: PrefabEdit[] = [];

  private readonly instances: Map<string, GameObject>;
  /** Ids of the instance's objects by ids in the prefab, new objects included. */
  private readonly ids: Map<string, string>;

  /** @param force - also drops overrides: the instance becomes equal to the prefab */
  constructor(
    private readonly root: GameObject,
    private readonly before: Prefab,
    private readonly after: Prefab,
    private readonly registry: ComponentRegistry,
    private readonly force = false,
  ) {
    this.instances = objectsBySource(root);
    this.ids = new Map([...this.instances].map(([source, { id }]) => [source, id]));
    this.addObjects();
    for (const next of after.objects) {
      const object = this.instances.get(next.id);
      if (object) this.mergeObject(object, objectsOf(before).get(next.id) ?? next, next);
    }
    this.removeObjects();
    if (force) this.removeAdded(root);
  }

  private addObjects(): void {
    for (const next of this.after.objects) {
      if (this.ids.has(next.id) || next.parent === null) continue;
      // an object that was removed from this instance is not added again
      if (objectsOf(this.before).has(next.id) && !this.force) continue;
      const parent = this.instances.get(next.parent);
      if (!parent) continue;
      const object = instantiatePrefab(this.after, this.registry, next.id, this.ids);
      object.traverse((each) => this.ids.set(each.prefabLink!.source, each.id));
      this.edits.push({ kind: 'add-object', object, parent });
    }
  }

  private removeObjects(): void {
    const kept = objectsOf(this.after);
    for (const { id, parent } of this.before.objects) {
      const object = kept.has(id) ? undefined : this.instances.get(id);
      // descendants of a removed object are removed with it
      if (object && parent !== null && kept.has(parent)) this.edits.push({ kind: 'remove-object', object });
    }
  }

  private removeAdded(object: GameObject): void {
    for (const child of object.children) {
      const source = child.prefabLink?.prefab === this.after.id ? child.prefabLink.source : null;
      if (source !== null && this.instances.get(source) === child) this.removeAdded(child);
      else this.edits.push({ kind: 'remove-object', object: child });
    }
  }

  private mergeObject(object: GameObject, base: FileObject, next: FileObject): void {
    const link = object.prefabLink!;
    const pinned = new Set<string>();
    /**
     * Whether the prefab's new value of a property replaces the instance's.
     * @param isBase - whether the instance's value equals the old prefab's
     * @param isNext - whether the instance's value equals the new prefab's
     */
    const takes = (path: string, isBase: boolean, isNext: boolean): boolean => {
      if (isOwnOfInstance(link.source, link.prefab, path)) return false;
      if (this.force) return !isNext;
      if (isBase && !link.pinned?.includes(path)) return !isNext;
      if (isNext) pinned.add(path);
      return false;
    };
    this.mergeParent(object, base, next);
    if (takes('name', object.name === base.name, object.name === next.name)) {
      this.edits.push({ kind: 'name', object, value: next.name });
    }
    const active = next.active ?? true;
    if (takes('active', object.active === (base.active ?? true), object.active === active)) {
      this.edits.push({ kind: 'active', object, value: active });
    }
    const isStatic = next.static ?? false;
    if (takes('static', object.isStatic === (base.static ?? false), object.isStatic === isStatic)) {
      this.edits.push({ kind: 'static', object, value: isStatic });
    }
    if (takes('tags', sameTags(object.tags, base.tags), sameTags(object.tags, next.tags))) {
      this.edits.push({ kind: 'tags', object, value: next.tags ?? [] });
    }
    this.mergeComponents(object, base, next, takes);
    const pins = [...pinned];
    if (!sameTags(pins, link.pinned)) {
      const { prefab, source } = link;
      const value = { prefab, source, ...(pins.length > 0 ? { pinned: pins } : {}) };
      this.edits.push({ kind: 'link', object, value });
    }
  }

  private mergeParent(object: GameObject, base: FileObject, next: FileObject): void {
    if (next.parent === null || object === this.root) return;
    const parent = this.instances.get(next.parent);
    if (!parent || object.parent === parent) return;
    const wasInPlace = base.parent !== null && object.parent === this.instances.get(base.parent);
    if (this.force || (wasInPlace && base.parent !== next.parent)) {
      this.edits.push({ kind: 'move-object', object, parent });
    }
  }

  private mergeComponents(
    object: GameObject,
    base: FileObject,
    next: FileObject,
    takes: (path: string, isBase: boolean, isNext: boolean) => boolean,
  ): void {
    const bases = componentsOf(base);
    const nexts = componentsOf(next);
    const present = new Map(object.components.map((component) => [keyOf(component), component]));
    for (const [key, component] of nexts) {
      const own = present.get(key);
      if (own) this.mergeFields(own, key, bases.get(key) ?? component, component, takes);
      else if (!bases.has(key) || this.force) this.addComponent(object, key, component);
    }
    for (const [key, component] of present) {
      const isRemoved = bases.has(key) && !nexts.has(key);
      if (isRemoved || (this.force && !nexts.has(key)))
        this.edits.push({ kind: 'remove-component', object, component });
    }
  }

  private addComponent(object: GameObject, key: string, data: FileComponent): void {
    if (this.registry.types.get(data.type)?.unique && object.getComponent(data.type)) return;
    const values = mapReferences(data.values, data.type, this.registry, this.ids);
    const component = this.registry.createFrom({ ...data, values });
    component.enabled = data.enabled ?? true;
    this.edits.push({ kind: 'add-component', object, component, id: `${object.id}:${key}` });
  }

  private mergeFields(
    own: Component,
    key: string,
    base: FileComponent,
    next: FileComponent,
    takes: (path: string, isBase: boolean, isNext: boolean) => boolean,
  ): void {
    if (own.typeName !== next.type) return;
    const enabled = next.enabled ?? true;
    if (takes(`${key}:enabled`, own.enabled === (base.enabled ?? true), own.enabled === enabled)) {
      this.edits.push({ kind: 'enabled', component: own, value: enabled });
    }
    for (const name of comparedFields(own, base, next)) {
      const field = own.fields[name];
      const value = own.getAuthored(name);
      const nextValue = valueIn(next, name, field, this.ids);
      if (nextValue === undefined) continue;
      const baseValue = valueIn(base, name, field, this.ids);
      const isBase = baseValue !== undefined && sameValue(value, baseValue);
      if (takes(`${key}.${name}`, isBase, sameValue(value, nextValue))) {
        this.edits.push({ kind: 'field', component: own, field: name, value: nextValue });
      }
    }
  }
}
