import type { AssetLibrary } from '../assets/AssetLibrary';
import type { ComponentRegistry } from './ComponentRegistry';

/** Options of the constructor of Scene. */
export interface SceneOptions {
  name?: string;
  /** Library of meshes and textures. When absent, the scene makes one, and disposes of it in `dispose`. */
  assets?: AssetLibrary;
  /** Known types of components; the built-in ones when absent. */
  registry?: ComponentRegistry;
}
