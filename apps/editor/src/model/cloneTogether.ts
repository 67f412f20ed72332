import type { GameObject } from '@farol/engine';
import { UnknownComponent } from '@farol/engine/files';

/** Clones objects, none of them a descendant of another; references among originals become references among clones. */
export function cloneTogether(objects: readonly GameObject[]): GameObject[] {
  const copies = objects.map((object) => object.clone());
  if (copies.length < 2) return copies;
  const ids = new Map<string, string>();
  objects.forEach((object, i) => noteIds(object, copies[i], ids));
  for (const copy of copies) copy.traverse((object) => retarget(object, ids));
  return copies;
}

function noteIds(object: GameObject, copy: GameObject, ids: Map<string, string>): void {
  ids.set(object.id, copy.id);
  object.children.forEach((child, i) => noteIds(child, copy.children[i], ids));
}

function retarget({ components }: GameObject, ids: ReadonlyMap<string, string>): void {
  for (const component of components) {
    for (const [name, { kind }] of Object.entries(component.fields)) {
      if (kind !== 'object' && !(component instanceof UnknownComponent)) continue;
      const value = component.getAuthored(name);
      const next = typeof value === 'string' ? ids.get(value) : undefined;
      if (next !== undefined) component.set(name, next);
    }
  }
}
