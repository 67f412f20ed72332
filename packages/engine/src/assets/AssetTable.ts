import { shortText } from '@farol/editing';
import type { AssetType } from '@farol/editing/fields';
import type { AssetChange, AssetFile, AssetSource } from './Asset';
import { AssetError } from './AssetError';
import { builtinAssets } from './builtinAssets';
import type { FieldAsset, FieldAssetType } from './FieldAsset';
import type { MaterialAsset } from './MaterialAsset';
import type { SurfaceAsset } from './SurfaceAsset';

/** Names of a list for a message: at most eight of them. */
export const sample = (names: readonly string[]): string =>
  names
    .slice(0, 8)
    .map((name) => shortText(name, 24))
    .join(', ') + (names.length > 8 ? ', …' : '');

/** Table of assets by name with their sources, the folders, and the listeners of changes. */
export abstract class AssetTable {
  protected readonly sources = new Map<string, AssetSource>();
  /** Names of a model's parts, by the model's name; some parts may no longer exist. */
  protected readonly parts = new Map<string, Set<string>>();
  protected readonly listeners = new Set<(change: AssetChange) => void>();
  protected readonly ownFolders = new Set<string>();

  has(name: string, type?: AssetType): boolean {
    const source = this.sources.get(name);
    return source !== undefined && (!type || source.type === type);
  }

  /** Names of all assets of a type, built-in ones first. */
  list(type?: AssetType): string[] {
    return [...this.sources].filter(([, source]) => !type || source.type === type).map(([name]) => name);
  }

  typeOf(name: string): AssetType | null {
    return this.sources.get(name)?.type ?? null;
  }

  /** The address that an asset was registered with, or null. */
  urlOf(name: string): string | null {
    const source = this.sources.get(name);
    return (source && 'url' in source && source.url) || null;
  }

  /** Null when `name` is an asset of this type, else the problem: "names the mesh 'x', which is unknown; …". */
  problemWith(type: AssetType, name: string): string | null {
    const source = this.sources.get(name);
    if (source?.type === type) return null;
    if (source) return `names '${shortText(name)}', which is a ${source.type}: a ${type} is needed.`;
    const known = this.list(type);
    const choices = known.length > 0 ? `known: ${sample(known)}` : `there is no ${type} yet`;
    return `names the ${type} '${shortText(name)}', which is unknown (${choices}): register it with the AssetLibrary first.`;
  }

  /** The bytes that an asset is read from; null when it was not added as a file. */
  fileOf(name: string): Blob | null {
    const source = this.sources.get(name);
    return (source && 'file' in source && source.file) || null;
  }

  /** Every asset that was added as a file. */
  get files(): AssetFile[] {
    return [...this.sources].flatMap(([name, source]) =>
      'file' in source && source.file ? [{ name, type: source.type, blob: source.file }] : [],
    );
  }

  /** Name of the model that an asset is a part of; null for an asset that is no part. */
  modelOf(name: string): string | null {
    const source = this.sources.get(name);
    return (source && 'partOf' in source && source.partOf) || null;
  }

  /** Names of the assets that are parts of a model. */
  partsOf(name: string): string[] {
    return [...(this.parts.get(name) ?? [])].filter((part) => this.modelOf(part) === name);
  }

  /** Whether an asset is built into the library, such as the box, or was added by `registerMaker`. */
  isBuiltin(name: string): boolean {
    const source = this.sources.get(name);
    return (
      Object.hasOwn(builtinAssets, name) || (source !== undefined && 'make' in source && source.isBuiltin === true)
    );
  }

  /** The field asset of this name; null for none. */
  fieldAsset(name: string): FieldAsset | null {
    const source = this.sources.get(name);
    return (source && 'edited' in source && source.edited) || null;
  }

  /** All field assets, or those of one type. */
  fieldAssets(type?: FieldAssetType): FieldAsset[] {
    return [...this.sources.values()].flatMap((source) =>
      'edited' in source && source.edited && (!type || source.type === type) ? source.edited : [],
    );
  }

  /** The material of this name whose fields can be edited; null for an asset of another type or of a model. */
  materialAsset(name: string): MaterialAsset | null {
    const asset = this.fieldAsset(name);
    return asset?.type === 'material' ? (asset as MaterialAsset) : null;
  }

  /** Every material whose fields can be edited. */
  get materialAssets(): MaterialAsset[] {
    return this.fieldAssets('material') as MaterialAsset[];
  }

  /** The surface of this name; null when there is none. */
  surface(name: string): SurfaceAsset | null {
    const asset = this.fieldAsset(name);
    return asset?.type === 'surface' ? (asset as SurfaceAsset) : null;
  }

  /** Whether the library has assets of the user's: files, materials, folders. */
  get hasOwn(): boolean {
    return this.ownFolders.size > 0 || this.files.length > 0 || this.fieldAssets().length > 0;
  }

  /** Paths of all folders, also empty ones: 'Props', 'Props/Lamps'. */
  get folders(): string[] {
    return [...this.ownFolders].toSorted();
  }

  /**
   * Adds or removes a folder; an asset's folder is part of its name, 'Props/robot.glb'.
   * @throws AssetError for an invalid path
   */
  setFolder(path: string, isThere: boolean): void {
    if (path.split('/').some((part) => part.trim() === ''))
      throw new AssetError(path, 'needs a name between all /: Props/Lamps.');
    if (this.ownFolders.has(path) === isThere) return;
    if (isThere) this.ownFolders.add(path);
    else this.ownFolders.delete(path);
    this.tell({ kind: 'folder', name: path });
  }

  /** Calls `listener` when an asset is registered, loaded, removed or fails. @returns function that removes the listener */
  onChange(listener: (change: AssetChange) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  protected addPart(model: string, part: string): void {
    const parts = this.parts.get(model);
    if (parts) parts.add(part);
    else this.parts.set(model, new Set([part]));
  }

  protected checkFree(name: string): void {
    if (!name) throw new AssetError(name, 'needs a name: give it one.');
    if (this.sources.has(name)) throw new AssetError(name, 'is there already: choose another name.');
  }

  protected tell(change: AssetChange): void {
    for (const listener of this.listeners) listener(change);
  }
}
