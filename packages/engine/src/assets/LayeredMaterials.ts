import type { Material } from 'three';
import { LayeredMaterial, type LayerValues } from './LayeredMaterial';
import type { SurfaceAsset } from './SurfaceAsset';
import type { TextureHost } from './writeSurfaceMaps';

/** Object that puts a surface (GLSL) of its own on top of its material's. */
export interface LayerUser {
  /** Name of the surface; null for none. */
  readonly surfaceName: string | null;
  /** Called when the material gets another surface, or its surface another text. */
  surfaceChanged(): void;
}

/** Materials of objects with surfaces of their own; users with equal values share one. */
export class LayeredMaterials {
  /** Objects that are called when their surface changes. */
  readonly users = new Set<LayerUser>();
  private readonly all = new Set<LayeredMaterial>();
  /** Shared materials by source material, then by surface and values. */
  private readonly shared = new Map<Material, Map<string, LayeredMaterial>>();

  constructor(private readonly textures: TextureHost) {}

  get size(): number {
    return this.all.size;
  }

  /**
   * A copy of `source` with one more surface on top; pass it to `release` after use.
   * @param asset - surface whose text has compiled
   * @param isOwn - true: not shared, since its user writes simulated values
   * @param before - the user's present copy: changed in place and returned when nobody else uses it; else the caller
   *   must release it
   */
  acquire(
    source: Material,
    asset: SurfaceAsset,
    values: LayerValues,
    isOwn: boolean,
    before: LayeredMaterial | undefined,
  ): LayeredMaterial {
    const key = isOwn ? null : JSON.stringify([asset.surface!.id, values.text, ...values.maps]);
    const known = key === null ? undefined : this.shared.get(source)?.get(key);
    if (known) {
      known.users++;
      return known;
    }
    if (before && before.users === 1 && before.source === source && before.asset === asset) {
      this.unshare(before);
      before.key = key;
      before.change(values);
      before.users++;
      this.share(before);
      return before;
    }
    const made = new LayeredMaterial(source, asset, key, values, this.textures);
    this.all.add(made);
    this.share(made);
    return made;
  }

  /** Releases one use of a material, which is disposed of after the last. */
  release(layered: LayeredMaterial): void {
    if (--layered.users > 0) return;
    this.unshare(layered);
    this.all.delete(layered);
    layered.dispose();
  }

  /** Tells the users of a surface that it, or its text, has changed. */
  surfaceChanged(asset: SurfaceAsset): void {
    for (const layered of this.all) if (layered.asset === asset) layered.refresh();
    for (const user of [...this.users]) if (user.surfaceName === asset.name) user.surfaceChanged();
  }

  /** Updates the copies of a source material after its own surface has changed. */
  sourceChanged(source: Material): void {
    for (const layered of this.all) if (layered.source === source) layered.refresh();
  }

  dispose(): void {
    for (const layered of this.all) layered.dispose();
    this.all.clear();
    this.shared.clear();
    this.users.clear();
  }

  private share(layered: LayeredMaterial): void {
    const { source, key } = layered;
    if (key === null) return;
    const known = this.shared.get(source);
    if (known) known.set(key, layered);
    else this.shared.set(source, new Map([[key, layered]]));
  }

  private unshare({ source, key }: LayeredMaterial): void {
    const known = key === null ? undefined : this.shared.get(source);
    if (!known) return;
    known.delete(key!);
    if (known.size === 0) this.shared.delete(source);
  }
}
