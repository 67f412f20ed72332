import { builtinComponents } from '../components/index';
import type { ComponentRegistry } from '../core/ComponentRegistry';
import { createId } from '../base/createId';
import type { GameObject } from '../core/GameObject';
import { makeObjects } from '../files/makeObjects';
import { copyObjects } from './copyObjects';
import type { Prefab } from '../core/Prefab';

/**
 * Makes an instance of a prefab, with new ids, in no scene yet; its objects have links to the prefab's.
 * @param from - id in the prefab of the subtree's top object; the root when absent
 * @param known - ids of existing objects of the instance, by their ids in the prefab
 */
export function instantiatePrefab(
  prefab: Prefab,
  registry: ComponentRegistry = builtinComponents,
  from = prefab.id,
  known: ReadonlyMap<string, string> = new Map(),
): GameObject {
  const wanted = new Set([from]);
  const objects = prefab.objects.filter(({ id, parent }) => {
    if (parent !== null && wanted.has(parent)) wanted.add(id);
    return wanted.has(id);
  });
  const ids = new Map([...known, ...objects.map(({ id }) => [id, createId()] as const)]);
  const copies = copyObjects(objects, registry, ids).map((copy, i) => ({
    ...copy,
    parent: i === 0 ? null : copy.parent,
    prefab: { prefab: prefab.id, source: objects[i].id },
  }));
  return makeObjects(copies, registry)[0];
}
