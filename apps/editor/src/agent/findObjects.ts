import type { GameObject, Scene } from '@farol/engine';

/** Path of an object: the names of its ancestors and its own, as in 'Street/Lamp 3'. */
export function pathOf(object: GameObject): string {
  return object.parent ? `${pathOf(object.parent)}/${object.name}` : object.name;
}

/**
 * The object of an id, a path or a name.
 * @throws Error that says what to give instead
 */
export function findObject(scene: Scene, reference: string): GameObject {
  const byId = scene.findById(reference);
  if (byId) return byId;
  const found: GameObject[] = [];
  const alike: string[] = [];
  const asked = reference.toLowerCase();
  scene.traverse((object) => {
    if (object.name === reference || (reference.includes('/') && pathOf(object) === reference)) found.push(object);
    else if (object.name.toLowerCase().includes(asked) || asked.includes(object.name.toLowerCase()))
      alike.push(object.name);
  });
  if (found.length === 1) return found[0];
  if (found.length > 1) {
    const ids = found.slice(0, 5).map((each) => `${pathOf(each)} (${each.id})`);
    throw new Error(`${found.length} objects are named “${reference}”: give a path or an id: ${ids.join(', ')}.`);
  }
  const mend = alike.length > 0 ? `; there is ${alike.slice(0, 5).join(', ')}` : '';
  throw new Error(`There is no object “${reference}”${mend}. get_scene lists all.`);
}

export const findObjects = (scene: Scene, references: readonly string[]): GameObject[] => [
  ...new Set(references.map((each) => findObject(scene, each))),
];
