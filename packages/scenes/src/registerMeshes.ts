import type { BufferGeometry } from 'three';
import type { AssetLibrary } from '@farol/engine';

/** Makers of meshes by asset name. */
export type MeshMakers = Readonly<Record<string, () => BufferGeometry>>;

/** Adds meshes, each made when it is first needed; a name that the library has already keeps its asset. */
export function registerMeshes(assets: AssetLibrary, meshes: MeshMakers): void {
  for (const [name, make] of Object.entries(meshes)) if (!assets.has(name)) assets.registerMaker(name, 'mesh', make);
}
