import type { Scene } from '../core/Scene';
import { drawnObjects, meshNamesOf } from './meshParts';

/** Resolves when all meshes that colliders of a scene are fitted to are loaded, or have failed. */
export async function shapesReady(scene: Scene): Promise<void> {
  const names = new Set<string>();
  for (const collider of scene.componentsOf('Collider')) {
    for (const object of drawnObjects(collider.gameObject)) {
      for (const { type, name } of meshNamesOf(object)) if (!scene.assets.isReady(type, name)) names.add(name);
    }
  }
  await Promise.allSettled([...names].map((name) => scene.assets.load(name)));
}
