import type { AssetUse } from './assetUses';
import type { FileAsset } from './FarolFile';

/** How many '/' of a name are looked at: a part of a model is 'robot.glb/mesh-1', the model's name may be a path. */
const SLASHES = 32;

/** The assets that a file brings along, by name. */
export class OwnAssets {
  private readonly byName: ReadonlyMap<string, FileAsset>;

  constructor(assets: readonly FileAsset[]) {
    this.byName = new Map(assets.map((asset) => [asset.name, asset]));
  }

  /** The asset of this name, else the model that it may be a part of; null when there is neither. */
  find(name: string): FileAsset | null {
    return this.byName.get(name) ?? this.modelOf(name);
  }

  /** Whether an asset of the file matches a use, or is a model that may contain it, which is known once loaded. */
  mayHold({ name, type }: AssetUse): boolean {
    const own = this.byName.get(name);
    return own ? own.type === type : this.modelOf(name) !== null;
  }

  private modelOf(name: string): FileAsset | null {
    let at = name.indexOf('/');
    for (let n = 0; at >= 0 && n < SLASHES; n++, at = name.indexOf('/', at + 1)) {
      const own = this.byName.get(name.slice(0, at));
      if (own?.type === 'model') return own;
    }
    return null;
  }
}
