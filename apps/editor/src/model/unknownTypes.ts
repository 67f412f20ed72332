import type { Scene } from '@farol/engine';
import { UnknownComponent } from '@farol/engine/files';

/** Types of the components of a scene that are kept as data, since no class of theirs is known. */
export function unknownTypes(scene: Scene): string[] {
  const types = new Set<string>();
  scene.traverse(({ components }) => {
    for (const each of components) if (each instanceof UnknownComponent) types.add(each.typeName);
  });
  return [...types];
}
