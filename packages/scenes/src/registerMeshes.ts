import type { BufferGeometry } from 'three';
import type { AssetLibrary } from '@farol/engine';

/** Makers of meshes by asset name. */
export type MeshMakers = Readonly<Record<string, () => BufferGeometry>>;

/** Registers meshes, each made on first use; existing assets of the same name are kept. */
export function registerMeshes(assets: AssetLibrary, meshes: MeshMakers): void {
  for (const [name, make] of Object.entries(meshes)) if (!assets.has(name)) assets.registerMaker(name, 'mesh', make);
}
