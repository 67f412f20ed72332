import { type FieldValue, sameValue } from '@farol/editing/fields';
import type { Component } from '../core/Component';
import type { GameObject } from '../core/GameObject';
import type { FileObject } from '../files/FarolFile';
import { instanceRootOf, isOwnOfInstance, keyOf, objectsBySource } from './instances';
import type { Prefab } from '../core/Prefab';
import { comparedFields, componentsOf, objectsOf, valueIn } from './prefabData';

/** A field of an instance whose value differs from its prefab's. */
export interface FieldOverride {
  readonly component: Component;
  readonly field: string;
  /** Path for messages: name of the object, key of the component, field, as in 'Lamp/Light.intensity'. */
  readonly path: string;
  /** The prefab's value; references are converted to ids of the instance. */
  readonly base: FieldValue;
}

/** Everything by which an instance differs from its prefab. */
export interface PrefabOverrides {
  readonly fields: readonly FieldOverride[];
  /** Differences between instance and prefab that are not field values: 'Lamp (active)', 'Lamp/Light added', 'Bulb removed'. */
  readonly structural: readonly string[];
}

interface Source {
  readonly prefab: Prefab;
  readonly data: FileObject;
  readonly root: GameObject;
}

function sourceOf(object: GameObject): Source | null {
  const root = instanceRootOf(object);
  const link = object.prefabLink;
  const prefab = (root && link && object.scene?.prefabs.get(link.prefab)) ?? null;
  const data = prefab && link ? objectsOf(prefab).get(link.source) : undefined;
  return root && prefab && data ? { prefab, data, root } : null;
}

const idsIn = (root: GameObject): Map<string, string> =>
  new Map([...objectsBySource(root)].map(([source, { id }]) => [source, id]));

/**
 * The override of an instance's field; null when the field follows the prefab, when each instance has the value for
 * itself (pose of the root), or when the component is in no prefab.
 */
export function fieldOverride(component: Component, field: string): FieldOverride | null {
  const object = component.gameObject;
  const source = object.prefabLink ? sourceOf(object) : null;
  if (!source) return null;
  const { data, prefab, root } = source;
  const key = keyOf(component);
  const path = `${key}.${field}`;
  const inPrefab = componentsOf(data).get(key);
  if (!inPrefab || inPrefab.type !== component.typeName || isOwnOfInstance(data.id, prefab.id, path)) return null;
  const declared = component.fields[field];
  const ids = declared.kind === 'object' ? idsIn(root) : new Map<string, string>();
  const base = valueIn(inPrefab, field, declared, ids);
  if (base === undefined) return null;
  const isOverride = !sameValue(component.getAuthored(field), base) || object.prefabLink!.pinned?.includes(path);
  return isOverride ? { component, field, path: `${object.name}/${path}`, base } : null;
}

/** Everything by which an instance differs from its prefab. @param root - root of the instance */
export function overridesOf(root: GameObject): PrefabOverrides {
  const source = sourceOf(root);
  if (!source) return { fields: [], structural: [] };
  const { prefab } = source;
  const instances = objectsBySource(root);
  const fields: FieldOverride[] = [];
  const others: string[] = [];
  for (const data of prefab.objects) {
    const object = instances.get(data.id);
    if (!object) {
      if (data.parent === null || instances.has(data.parent)) others.push(`${data.name} removed`);
      continue;
    }
    const { name } = object;
    if (name !== data.name && object !== root) others.push(`${data.name} (named ${name})`);
    if (object.active !== (data.active ?? true)) others.push(`${name} (active)`);
    if (object.isStatic !== (data.static ?? false)) others.push(`${name} (static)`);
    if (object.tags.join('\n') !== (data.tags ?? []).join('\n')) others.push(`${name} (tags)`);
    const known = componentsOf(data);
    const present = new Set(object.components.map(keyOf));
    for (const key of known.keys()) if (!present.has(key)) others.push(`${name}/${key} removed`);
    for (const component of object.components) {
      const key = keyOf(component);
      const inPrefab = known.get(key);
      if (!inPrefab) others.push(`${name}/${key} added`);
      else if (component.enabled !== (inPrefab.enabled ?? true)) others.push(`${name}/${key} (enabled)`);
      for (const field of comparedFields(component, ...(inPrefab ? [inPrefab] : []))) {
        const override = fieldOverride(component, field);
        if (override) fields.push(override);
      }
    }
    for (const child of object.children) {
      if (instances.get(child.prefabLink?.source ?? '') !== child) others.push(`${child.name} added`);
    }
  }
  return { fields, structural: others };
}
