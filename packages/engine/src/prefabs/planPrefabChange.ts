import { shortText } from '@farol/editing';
import type { GameObject } from '../core/GameObject';
import type { Scene } from '../core/Scene';
import { makeObjects } from '../files/makeObjects';
import { counted } from '../base/counted';
import { fileLimits } from '../guard/fileLimits';
import { serializeObject } from '../files/serialize';
import { InstanceUpdate } from './InstanceUpdate';
import { isInstanceRoot } from './instances';
import { type Prefab, PrefabError } from '../core/Prefab';
import { applyPrefabEdit, type PrefabEdit } from './PrefabEdit';
import { PrefabSizes } from '../files/PrefabSizes';

/** Changes that follow from a new version of a prefab; nothing is changed until they are applied. */
export interface PrefabPlan {
  /** New data of the prefab, and of prefabs with instances of it. */
  readonly prefabs: readonly Prefab[];
  /** Edits of the scene's objects, in order. */
  readonly edits: readonly PrefabEdit[];
}

function rootsIn(object: GameObject, changed: ReadonlyMap<string, Prefab>): GameObject[] {
  const roots: GameObject[] = [];
  object.traverse((each) => {
    if (isInstanceRoot(each) && changed.has(each.prefabLink!.prefab)) roots.push(each);
  });
  return roots;
}

/** A prefab with its nested instances of changed prefabs updated; null when nothing changes. */
function follow(scene: Scene, prefab: Prefab, changed: ReadonlyMap<string, Prefab>): Prefab | null {
  if (!prefab.objects.some(({ prefab: link }) => link && changed.has(link.prefab))) return null;
  const [root] = makeObjects(prefab.objects, scene.registry);
  let edits = 0;
  for (const instance of rootsIn(root, changed)) {
    const { prefab: id } = instance.prefabLink!;
    const update = new InstanceUpdate(instance, scene.prefabs.get(id)!, changed.get(id)!, scene.registry);
    update.edits.forEach(applyPrefabEdit);
    edits += update.edits.length;
  }
  if (edits === 0) return null;
  const objects: Prefab['objects'][number][] = [];
  root.traverse((each) => objects.push(serializeObject(each)));
  return { ...prefab, objects };
}

/** All prefabs except one, each after the prefabs that it contains. */
function inOrder(scene: Scene, except: string): Prefab[] {
  const done = new Set([except]);
  const ordered: Prefab[] = [];
  const visit = (prefab: Prefab | null): void => {
    if (!prefab || done.has(prefab.id)) return;
    done.add(prefab.id);
    for (const { prefab: link } of prefab.objects) if (link) visit(scene.prefabs.get(link.prefab));
    ordered.push(prefab);
  };
  scene.prefabs.list.forEach(visit);
  return ordered;
}

/** @throws PrefabError when a prefab would contain itself, or exceed the limits of a file */
function checkChange(scene: Scene, next: Prefab): void {
  const free = new Set<string>();
  for (const { name, prefab: link } of next.objects) {
    if (!link || free.has(link.prefab)) continue;
    free.add(link.prefab);
    if (scene.prefabs.contains(link.prefab, next.id)) {
      throw new PrefabError(
        next.name,
        `would hold itself, by its object '${shortText(name)}': take that one out, or unpack it.`,
      );
    }
  }
  const prefabs = new Map(scene.prefabs.list.map((prefab) => [prefab.id, prefab]));
  prefabs.set(next.id, next);
  const sizes = new PrefabSizes(prefabs);
  for (const { id, name } of prefabs.values()) {
    if (sizes.depthOf(id) > fileLimits.prefabDepth) {
      throw new PrefabError(name, `would hold prefabs more than ${fileLimits.prefabDepth} deep: unpack some of them.`);
    }
    if (sizes.sizeOf(id) > fileLimits.objects) {
      const most = counted(fileLimits.objects);
      throw new PrefabError(name, `would come to more than ${most} objects: take instances out of it.`);
    }
  }
}

/**
 * Plans the change of a prefab to `next`: edits of prefabs that contain it, and of its instances in the scene, which
 * keep their overrides. Changes nothing itself; see `changePrefab`.
 * @param except - root of an instance that already equals the new prefab
 * @throws PrefabError when the prefab would contain itself, or exceed the limits of a file
 */
export function planPrefabChange(scene: Scene, next: Prefab, except: GameObject | null = null): PrefabPlan {
  checkChange(scene, next);
  const before = scene.prefabs.get(next.id);
  const changed = new Map([[next.id, next]]);
  if (!before) return { prefabs: [next], edits: [] };
  for (const prefab of inOrder(scene, next.id)) {
    const followed = follow(scene, prefab, changed);
    if (followed) changed.set(prefab.id, followed);
  }
  const edits: PrefabEdit[] = [];
  for (const root of scene.roots) {
    for (const instance of rootsIn(root, changed)) {
      if (instance === except) continue;
      const { prefab: id } = instance.prefabLink!;
      edits.push(...new InstanceUpdate(instance, scene.prefabs.get(id)!, changed.get(id)!, scene.registry).edits);
    }
  }
  return { prefabs: [...changed.values()], edits: withoutLost(edits) };
}

/** Drops removals of objects below another removed object. */
function withoutLost(edits: readonly PrefabEdit[]): PrefabEdit[] {
  const removed = new Set<GameObject>();
  for (const edit of edits) if (edit.kind === 'remove-object') removed.add(edit.object);
  return edits.filter((edit) => {
    if (edit.kind !== 'remove-object') return true;
    let above = edit.object.parent;
    while (above && !removed.has(above)) above = above.parent;
    return !above;
  });
}

/** Adds a prefab, or replaces the one of the same id: its instances are updated, and keep their overrides. */
export function changePrefab(scene: Scene, next: Prefab): void {
  const plan = planPrefabChange(scene, next);
  for (const prefab of plan.prefabs) scene.prefabs.set(prefab);
  plan.edits.forEach(applyPrefabEdit);
}
