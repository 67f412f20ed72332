import type { FieldValue } from '@farol/editing/fields';
import { BufferGeometry, type Material } from 'three';
import type { MaterialUser, TakenAsset } from './Asset';
import { AssetError } from './AssetError';
import { ClipAsset } from './clips/ClipAsset';
import type { FieldAsset, FieldAssetType } from './FieldAsset';
import { LayeredMaterials } from './LayeredMaterials';
import { MaterialAsset, type MaterialHost } from './MaterialAsset';
import { MaterialCache } from './MaterialCache';
import { ScriptAsset } from './ScriptAsset';
import { SurfaceAsset, type SurfaceHost } from './SurfaceAsset';
import { UseCounter } from './UseCounter';
import { DerivedAssets } from './DerivedAssets';

export type { AssetLibraryOptions } from './LoadedAssets';

/** The meshes, textures, materials and shaders that scenes refer to by name. Built-in ones are made on demand. */
export class AssetLibrary extends DerivedAssets implements MaterialHost, SurfaceHost {
  /** Materials made from the fields of ObjectRenderers, shared where the values are equal. */
  readonly materials = new MaterialCache(this);
  /** @internal Materials of objects with a surface of their own. */
  readonly layered = new LayeredMaterials(this);
  /** Scene time (s) that is passed to the shaders of surfaces. */
  readonly surfaceTime = { value: 0 };
  /** Numbers of users of shared geometries and textures. */
  readonly uses = new UseCounter();

  private readonly materialUsers = new Map<string, Set<MaterialUser>>();

  /**
   * Adds a material defined by field values, which objects share and editors can change.
   * @param values - values in place of the defaults; named textures may be added later
   * @throws AssetError when the name is taken; FieldError for a value that is not allowed
   */
  addMaterial(name: string, values: Readonly<Record<string, FieldValue>> = {}): MaterialAsset {
    return this.addFieldAsset('material', name, values) as MaterialAsset;
  }

  /**
   * Adds an asset defined by field values.
   * @param values - values in place of the defaults; named assets may be added later
   * @throws AssetError when the name is taken; FieldError for a value that is not allowed
   */
  addFieldAsset(type: FieldAssetType, name: string, values: Readonly<Record<string, FieldValue>> = {}): FieldAsset {
    this.checkFree(name);
    if (type === 'material') {
      const edited = new MaterialAsset(this, name, values);
      this.sources.set(name, { type, make: () => edited.three, edited });
    } else if (type === 'surface') {
      const edited = new SurfaceAsset(this, name, values);
      this.sources.set(name, { type, make: () => edited, edited });
    } else {
      const edited = type === 'script' ? new ScriptAsset(this, name, values) : new ClipAsset(this, name, values);
      this.sources.set(name, { type, make: () => edited, edited });
    }
    this.tell({ kind: 'registered', name, type });
    const asset = this.fieldAsset(name)!;
    if (type === 'surface') (asset as SurfaceAsset).begin();
    return asset;
  }

  /**
   * Renames an asset and its parts. The caller updates fields that refer to the old name.
   * @returns new names of all renamed assets, by old name
   * @throws AssetError when it is built in, a part of a model or unknown, or the name is taken
   */
  rename(from: string, to: string): Map<string, string> {
    const source = this.sources.get(from);
    if (!source) throw new AssetError(from, 'is not in the library any more: choose another one.');
    if (this.isBuiltin(from))
      throw new AssetError(from, 'came with Farol, and keeps its name: choose one of your own.');
    if ('partOf' in source && source.partOf) throw new AssetError(from, `is a part of ${source.partOf}: rename that.`);
    this.checkFree(to);
    const names = new Map([[from, to]]);
    for (const part of this.partsOf(from)) names.set(part, to + part.slice(from.length));
    for (const name of names.values()) this.checkFree(name);
    for (const [before, after] of names) this.renameOne(before, after, to);
    this.parts.delete(from);
    for (const [before, after] of names) {
      const { type } = this.sources.get(after)!;
      this.tell({ kind: 'removed', name: before, type });
      this.tell({ kind: 'registered', name: after, type });
    }
    return names;
  }

  /** Registers a component that is called when three's material of this name is replaced. */
  addMaterialUser(name: string, user: MaterialUser): void {
    const users = this.materialUsers.get(name);
    if (users) users.add(user);
    else this.materialUsers.set(name, new Set([user]));
  }

  removeMaterialUser(name: string, user: MaterialUser): void {
    const users = this.materialUsers.get(name);
    users?.delete(user);
    if (users?.size === 0) this.materialUsers.delete(name);
  }

  /** @internal */
  surfaceChanged(asset: SurfaceAsset, problem: Error | null): void {
    const { name, type } = asset;
    if (this.fieldAsset(name) !== asset) return;
    for (const material of this.materialAssets) if (material.get('surface') === name) material.surfaceChanged();
    this.layered.surfaceChanged(asset);
    if (problem) this.tell({ kind: 'failed', name, type, error: problem });
    else this.tell({ kind: 'loaded', name, type });
  }

  /** @internal */
  materialWears(material: Material): void {
    this.layered.sourceChanged(material);
  }

  /** @internal Tells the components that use a material that its displacement changed, for their bounds. */
  materialShapeChanged(name: string): void {
    for (const user of [...(this.materialUsers.get(name) ?? [])]) user.materialReplaced();
  }

  /** @internal */
  fieldAssetChanged(asset: FieldAsset, field: string, before: FieldValue, isReplaced: boolean): void {
    const { name, type } = asset;
    if (isReplaced) {
      this.values.delete(name);
      for (const user of [...(this.materialUsers.get(name) ?? [])]) user.materialReplaced();
    }
    if (this.fieldAsset(name) === asset) this.tell({ kind: 'changed', name, type, asset, field, before });
  }

  /**
   * Removes an asset with its parts, for `restore` to add it again; objects that use it keep it.
   * @throws AssetError when there is no asset of this name
   */
  take(name: string): TakenAsset {
    const source = this.sources.get(name);
    if (!source) throw new AssetError(name, 'is not in the library any more: choose another one.');
    const parts = this.partsOf(name).map((part) => this.take(part));
    const value = this.values.get(name);
    this.unregister(name);
    return { name, source, value, parts };
  }

  /** Adds an asset again that `take` has removed. @throws AssetError when the name is in use again */
  restore({ name, source, value, parts }: TakenAsset): void {
    this.checkFree(name);
    this.sources.set(name, source);
    if ('partOf' in source && source.partOf !== undefined) this.addPart(source.partOf, name);
    if (value) this.values.set(name, value);
    for (const part of parts) this.restore(part);
    this.tell({ kind: 'registered', name, type: source.type });
    if (source.type === 'surface') this.surface(name)?.begin();
  }

  /** Removes an added asset with its parts; objects that use it keep it. The asset is not disposed of. */
  unregister(name: string): void {
    const source = this.sources.get(name);
    if (!source) return;
    for (const part of this.partsOf(name)) this.unregister(part);
    this.sources.delete(name);
    const value = this.values.get(name);
    if (value instanceof BufferGeometry) this.normals.forget(value);
    if ('edited' in source) source.edited?.dispose();
    this.values.delete(name);
    this.repeated.delete(name);
    this.refused.delete(name);
    this.tell({ kind: 'removed', name, type: source.type });
  }

  /** Frees the GPU memory of all assets, and removes them. */
  dispose(): void {
    this.layered.dispose();
    this.materials.dispose();
    this.normals.dispose();
    for (const copies of this.repeated.values()) for (const each of copies.values()) each.dispose();
    for (const value of this.values.values()) value.dispose();
    for (const asset of this.fieldAssets()) asset.dispose();
    this.materialUsers.clear();
    this.ownFolders.clear();
    this.repeated.clear();
    this.values.clear();
    this.sources.clear();
    this.listeners.clear();
  }

  private renameOne(before: string, after: string, model: string): void {
    const source = this.sources.get(before)!;
    this.sources.delete(before);
    const partOf = 'partOf' in source && source.partOf !== undefined ? model : undefined;
    this.sources.set(after, partOf === undefined ? source : { ...source, partOf });
    if (partOf !== undefined) this.addPart(model, after);
    if ('edited' in source && source.edited) source.edited.name = after;
    for (const map of [this.values, this.repeated, this.materialUsers] as Map<string, unknown>[]) {
      if (map.has(before)) map.set(after, map.get(before));
      map.delete(before);
    }
    if (this.refused.delete(before)) this.refused.add(after);
  }
}
