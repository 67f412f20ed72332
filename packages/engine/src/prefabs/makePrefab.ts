import { shortText } from '@farol/editing';
import { builtinComponents } from '../components/index';
import { createId } from '../base/createId';
import type { GameObject } from '../core/GameObject';
import { serializeObject } from '../files/serialize';
import { copyObjects } from './copyObjects';
import { instanceRootOf } from './instances';
import { type Prefab, PrefabError, type PrefabLink } from '../core/Prefab';

/** A prefab, and the links that turn its source objects into an instance. */
export interface MadePrefab {
  readonly prefab: Prefab;
  readonly links: ReadonlyMap<GameObject, PrefabLink>;
}

/**
 * Makes a prefab of an object and its descendants; the scene is not changed. Instances of other prefabs among them stay
 * nested instances.
 * @throws PrefabError when the object is a part of an instance: use the whole instance, or unpack it
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
 * Makes prefab data from an object tree.
 * @param sources - ids that objects already have in the prefab; other objects get new ones
 * @param old - links of the prefab's present objects
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
