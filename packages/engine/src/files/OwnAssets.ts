import type { AssetUse } from './assetUses';
import type { FileAsset } from './FarolFile';

/** Number of '/' in an asset's name before which a model's name is looked for: 'robot.glb' in 'robot.glb/mesh-1'. */
const SLASHES = 32;

/** Assets that a scene file contains, by name. */
export class OwnAssets {
  private readonly byName: ReadonlyMap<string, FileAsset>;

  constructor(assets: readonly FileAsset[]) {
    this.byName = new Map(assets.map((asset) => [asset.name, asset]));
  }

  /** Asset of this name, else the model of which it may be a part; null for neither. */
  find(name: string): FileAsset | null {
    return this.byName.get(name) ?? this.modelOf(name);
  }

  /**
   * Whether the file has the named asset with the right type, or a model that may contain it; parts are known once the
   * model is loaded.
   */
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
