import type { AssetLibrary } from '@farol/engine';
import { registerMeshes } from './registerMeshes';
import { atriumMeshes } from './sponza/atriumMeshes';
import { templeMeshes } from './temple/templeMeshes';

/**
 * Adds the meshes that demo scenes have of their own, such as 'temple/column'. Building a scene adds that scene's meshes by
 * itself, and `deserialize` those that a file names; an editor adds all, to offer them in every scene.
 */
export function registerSceneAssets(assets: AssetLibrary): void {
  registerMeshes(assets, templeMeshes);
  registerMeshes(assets, atriumMeshes);
}
