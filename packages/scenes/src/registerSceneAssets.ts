import type { AssetLibrary } from '@farol/engine';
import { registerMeshes } from './registerMeshes';
import { atriumMeshes } from './sponza/atriumMeshes';
import { templeMeshes } from './temple/templeMeshes';

/**
 * Registers the meshes of the demo scenes, such as 'temple/column'. Demo scenes register their own meshes, and
 * `deserialize` those that a file names; an editor registers all, to offer them in every scene.
 */
export function registerSceneAssets(assets: AssetLibrary): void {
  registerMeshes(assets, templeMeshes);
  registerMeshes(assets, atriumMeshes);
}
