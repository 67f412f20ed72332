import { sameValue } from '@farol/editing/fields';
import { withViewedValue } from '../fields/storedValues';
import type { Component } from '../core/Component';
import type { GameObject } from '../core/GameObject';
import type { FileComponent, FileObject } from '../files/FarolFile';
import { InstanceUpdate } from './InstanceUpdate';
import { componentKey, instanceRootOf, keyOf, objectsBySource } from './instances';
import { readPrefab } from './makePrefab';
import { type Prefab, PrefabError, type PrefabLink } from '../core/Prefab';
import { objectsOf } from './prefabData';
import type { PrefabEdit } from './PrefabEdit';
import { planPrefabChange, type PrefabPlan } from './planPrefabChange';

function prefabOf(root: GameObject | null): { root: GameObject; prefab: Prefab } {
  const id = root?.prefabLink?.prefab ?? '';
  const prefab = root?.scene?.prefabs.get(id);
  if (!root || !prefab)
    throw new PrefabError(id, 'is not in the scene, or the object is not an instance of it: choose an instance.');
  return { root, prefab };
}

const sourcesOf = (root: GameObject): Map<GameObject, string> =>
  new Map([...objectsBySource(root)].map(([source, object]) => [object, source]));

/** Restores the properties of a prefab's root that each instance has for itself: name and pose. */
function withOwnOf(root: FileObject, old: FileObject): FileObject {
  const values = old.components.find(({ type }) => type === 'Transform')?.values ?? {};
  const components = root.components.map((component): FileComponent => {
    if (component.type !== 'Transform') return component;
    const { position: _position, rotation: _rotation, ...rest } = component.values;
    const { position, rotation } = values;
    return { ...component, values: { ...(position && { position }), ...(rotation && { rotation }), ...rest } };
  });
  return { ...root, name: old.name, components };
}

/**
 * Plan that makes a prefab equal to one of its instances; other instances follow. Position, rotation and name of the
 * instance's root are not copied.
 * @param instance - the root of an instance in a scene
 * @throws PrefabError when the prefab was removed, or would contain itself
 */
export function planApplyAll(instance: GameObject): PrefabPlan {
  const { root, prefab } = prefabOf(instance);
  const known = objectsOf(prefab);
  const old = new Map([...known].map(([id, object]) => [id, object.prefab]));
  const made = readPrefab(root, prefab.name, prefab.id, sourcesOf(root), old);
  const [first, ...rest] = made.prefab.objects;
  const next = { ...made.prefab, objects: [withOwnOf(first, known.get(prefab.id)!), ...rest] };
  const plan = planPrefabChange(root.scene!, next, root);
  const links = [...made.links]
    .filter(([object, link]) => !sameLink(object.prefabLink, link))
    .map(([object, value]): PrefabEdit => ({ kind: 'link', object, value }));
  return { prefabs: plan.prefabs, edits: [...plan.edits, ...links] };
}

const sameLink = (a: PrefabLink | null, b: PrefabLink): boolean =>
  a?.prefab === b.prefab && a.source === b.source && !a.pinned;

/** An instance's link to its prefab without one of its `pinned` paths, whose field then follows the prefab again. */
export function withoutPin(link: PrefabLink, path: string): PrefabLink {
  const { prefab, source } = link;
  const pinned = link.pinned?.filter((each) => each !== path) ?? [];
  return { prefab, source, ...(pinned.length > 0 ? { pinned } : {}) };
}

/** Plan that copies one field of an instance to its prefab. @throws PrefabError when the object is in no instance */
export function planApplyField(component: Component, field: string): PrefabPlan {
  const object = component.gameObject;
  const { root, prefab } = prefabOf(instanceRootOf(object));
  const sources = new Map([...sourcesOf(root)].map(([each, source]) => [each.id, source]));
  const link = object.prefabLink!;
  const key = keyOf(component);
  const own = component.getAuthored(field);
  const declared = component.fields[field];
  const value = declared.kind === 'object' && typeof own === 'string' ? (sources.get(own) ?? null) : own;
  const objects = prefab.objects.map((data): FileObject => {
    if (data.id !== link.source) return data;
    const components = data.components.map((each): FileComponent => {
      if (componentKey(data.id, each.id) !== key) return each;
      if (declared.viewOf !== undefined)
        return { ...each, values: withViewedValue(each.values, field, declared, value) };
      const { [field]: _before, ...others } = each.values;
      return { ...each, values: sameValue(value, declared.default) ? others : { ...others, [field]: value } };
    });
    return { ...data, components };
  });
  const plan = planPrefabChange(root.scene!, { ...prefab, objects }, root);
  const path = `${key}.${field}`;
  if (!link.pinned?.includes(path)) return plan;
  return { ...plan, edits: [...plan.edits, { kind: 'link', object, value: withoutPin(link, path) }] };
}

/** Edits that make an instance equal to its prefab. @param instance - root of the instance */
export function planRevertAll(instance: GameObject): PrefabEdit[] {
  const { root, prefab } = prefabOf(instance);
  return new InstanceUpdate(root, prefab, prefab, root.scene!.registry, true).edits;
}

/**
 * Edits that turn an instance into plain objects with the same values. Nested instances become independent instances.
 */
export function planUnpack(instance: GameObject): PrefabEdit[] {
  const { root, prefab } = prefabOf(instance);
  const data = objectsOf(prefab);
  return [...objectsBySource(root)].map(([source, object]): PrefabEdit => {
    return { kind: 'link', object, value: data.get(source)?.prefab ?? null };
  });
}
