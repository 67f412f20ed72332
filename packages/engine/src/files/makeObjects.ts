import { builtinComponents } from '../components/index';
import type { ComponentRegistry } from '../core/ComponentRegistry';
import { GameObject } from '../core/GameObject';
import type { FileObject } from './FarolFile';

/** Makes one GameObject, without children and parent, from checked data. */
function makeObject(data: FileObject, registry: ComponentRegistry): GameObject {
  const gameObject = new GameObject(data.name, { id: data.id });
  gameObject.tags = data.tags ?? [];
  gameObject.prefabLink = data.prefab ?? null;
  for (const component of data.components) {
    const { type, id, enabled, values } = component;
    if (type === 'Transform') {
      for (const name of Object.keys(values)) gameObject.transform.set(name, values[name]);
      gameObject.transform.enabled = enabled ?? true;
      continue;
    }
    gameObject.addComponent(registry.createFrom(component), {}, { id, enabled });
  }
  gameObject.active = data.active ?? true;
  gameObject.locked = data.locked ?? false;
  gameObject.isStatic = data.static ?? false;
  return gameObject;
}

/** Makes the linked objects of a checked file. Parents may come after their children. @returns the top objects */
export function makeObjects(
  objects: readonly FileObject[],
  registry: ComponentRegistry = builtinComponents,
): GameObject[] {
  const byId = new Map(objects.map((data) => [data.id, makeObject(data, registry)]));
  const roots: GameObject[] = [];
  for (const { id, parent } of objects) {
    const gameObject = byId.get(id)!;
    if (parent === null) roots.push(gameObject);
    else byId.get(parent)!.add(gameObject);
  }
  return roots;
}
