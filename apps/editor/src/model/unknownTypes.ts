import type { Scene } from '@farol/engine';
import { UnknownComponent } from '@farol/engine/files';

/** Component types of a scene whose class is unknown; their components are kept as data. */
export function unknownTypes(scene: Scene): string[] {
  const types = new Set<string>();
  scene.traverse(({ components }) => {
    for (const each of components) if (each instanceof UnknownComponent) types.add(each.typeName);
  });
  return [...types];
}
