import type { AssetLibrary, Scene } from '@farol/engine';
import type { AssetType } from '@farol/engine/fields';

/** What the Assets panel shows: assets of the library, and prefabs. */
export type AssetKind = AssetType | 'prefab';

/** One card of the Assets panel. */
export interface AssetEntry {
  readonly kind: AssetKind;
  /** Name of the asset, id of the prefab. */
  readonly name: string;
  readonly label: string;
  /** Whether it came with Farol, and cannot be deleted. */
  readonly isBuiltin: boolean;
}

/** Whether a texture is one of light from all sides. */
export const isEnvironment = (name: string): boolean => /\.(hdr|exr)$/i.test(name);

/** Everything that can be used in a scene: its own first, parts of models after them. */
export function assetEntries(scene: Scene): AssetEntry[] {
  const { assets } = scene;
  const prefabs = scene.prefabs.list.map(({ id, name }): AssetEntry => {
    return { kind: 'prefab', name: id, label: name, isBuiltin: false };
  });
  const entries = assets.list().map((name): AssetEntry => {
    return { kind: assets.typeOf(name)!, name, label: labelOf(assets, name), isBuiltin: assets.isBuiltin(name) };
  });
  const rank = ({ name, isBuiltin }: AssetEntry): number => (isBuiltin ? 2 : assets.modelOf(name) ? 1 : 0);
  return [...prefabs, ...entries.toSorted((a, b) => rank(a) - rank(b))];
}

const labelOf = (assets: AssetLibrary, name: string): string =>
  assets.modelOf(name) ? name.slice(name.lastIndexOf('/') + 1) : name;
