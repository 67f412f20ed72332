import type { AssetLibrary } from './AssetLibrary';

/** Fetches a function that registers a package's meshes with a library; existing assets of the same name are kept. */
export type MeshPack = () => Promise<(assets: AssetLibrary) => void>;

const packs = new Set<MeshPack>();

/**
 * Lets scene files name meshes that a package makes in code, such as 'temple/column': `deserialize` fetches the pack when a file
 * names a mesh in a folder that the library does not have.
 */
export function addMeshPack(pack: MeshPack): void {
  packs.add(pack);
}

/** Registers the meshes of every pack. @returns names that were not in the library before */
export async function registerMeshPacks(assets: AssetLibrary): Promise<string[]> {
  const before = new Set(assets.list());
  for (const pack of packs) (await pack())(assets);
  return assets.list().filter((name) => !before.has(name));
}
