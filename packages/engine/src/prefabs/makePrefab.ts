import { shortText } from '@farol/editing';
import { builtinComponents } from '../components/index';
import { createId } from '../base/createId';
import type { GameObject } from '../core/GameObject';
import { serializeObject } from '../files/serialize';
import { copyObjects } from './copyObjects';
import { instanceRootOf } from './instances';
import { type Prefab, PrefabError, type PrefabLink } from '../core/Prefab';

/** A prefab, and how the objects that it was made of link to it. */
export interface MadePrefab {
  readonly prefab: Prefab;
  readonly links: ReadonlyMap<GameObject, PrefabLink>;
}

/**
 * A prefab of an object with all below it; nothing of the scene changes. Instances of other prefabs below it, or it
 * itself, stay instances within the new one.
 * @throws PrefabError when the object is a part of an instance: the whole instance can be taken, or its parts unpacked
 */
export function makePrefab(object: GameObject, name = object.name, id = createId()): MadePrefab {
  const outer = instanceRootOf(object);
  if (outer && outer !== object) {
    throw new PrefabError(
      name,
      `cannot be made of a part of '${shortText(outer.name)}', which is an instance itself: unpack that first.`,
    );
  }
  return readPrefab(object, name, id, new Map([[object, id]]));
}

/**
 * Prefab data made of a whole tree.
 * @param sources - ids that objects have in it already; the others get new ones
 * @param old - the links within the prefab of objects that are in it already
 */
export function readPrefab(
  root: GameObject,
  name: string,
  id: string,
  sources: ReadonlyMap<GameObject, string>,
  old: ReadonlyMap<string, PrefabLink | undefined> = new Map(),
): MadePrefab {
  const registry = root.scene?.registry ?? builtinComponents;
  const objects: GameObject[] = [];
  root.traverse((each) => objects.push(each));
  const ids = new Map(objects.map((each) => [each.id, sources.get(each) ?? createId()]));
  const links = new Map<GameObject, PrefabLink>();
  const data = copyObjects(objects.map(serializeObject), registry, ids).map((copy, i) => {
    const { prefab, ...rest } = copy;
    const link = old.has(copy.id) ? old.get(copy.id) : prefab;
    links.set(objects[i], { prefab: id, source: copy.id });
    return { ...rest, ...(link ? { prefab: link } : {}) };
  });
  return { prefab: { id, name, objects: data }, links };
}
