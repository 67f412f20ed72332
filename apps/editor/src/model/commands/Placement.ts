import type { GameObject, Scene } from '@farol/engine';

/** Parent of GameObjects: another one, or the scene. */
export type Container = GameObject | Scene;

/** A place in the tree: `index` among the children of `parent`. */
export interface Placement {
  readonly object: GameObject;
  readonly parent: Container;
  readonly index: number;
}

/** Direct children of a scene or a GameObject. */
export function childrenOf(container: Container): readonly GameObject[] {
  return 'roots' in container ? container.roots : container.children;
}

/** The parent of a GameObject, or the scene for a root. */
export function containerOf(object: GameObject, scene: Scene): Container {
  return object.parent ?? scene;
}

/** Current place of a GameObject in its scene. */
export function placementOf(object: GameObject, scene: Scene): Placement {
  const parent = containerOf(object, scene);
  return { object, parent, index: childrenOf(parent).indexOf(object) };
}

/** The objects of a list that are not below another of the list, in tree order, each once. */
export function topmost(objects: readonly GameObject[], scene: Scene): GameObject[] {
  const listed = new Set(objects);
  const found: GameObject[] = [];
  const visit = (object: GameObject): void => {
    if (listed.has(object)) found.push(object);
    else object.children.forEach(visit);
  };
  if (listed.size > 0) scene.roots.forEach(visit);
  return found;
}
