import { type BufferGeometry, type Material, RepeatWrapping, type Texture } from 'three';
import type { AssetType } from '../fields/Field';
import { computeCreaseNormals } from '../geometry/computeCreaseNormals';
import { type Asset, type AssetChange, type AssetSource, assetTypeOf } from './Asset';
import { AssetError } from './AssetError';
import { builtinAssets } from './builtinAssets';
import { type FetchBytes, fetchBytes, loadAsset, typeOfUrl } from './loadAsset';
import { MaterialCache } from './MaterialCache';
import { UseCounter } from './UseCounter';

export interface AssetLibraryOptions {
  /**
   * Addresses of assets by name: 'dragon' gets the Stanford dragon's PLY (may be gzip); other names become new assets,
   * their type told by the ending of the address.
   */
  urls?: Readonly<Record<string, string>>;
  /** How the bytes of an address are read; `fetch` when absent. */
  fetchBytes?: FetchBytes;
}

/** Nearest thing that was meant, for messages: at most eight names of the type. */
const sample = (names: readonly string[]): string => names.slice(0, 8).join(', ') + (names.length > 8 ? ', …' : '');

/** The meshes, textures, materials and shaders that scenes name. Built-in ones are made on demand. */
export class AssetLibrary {
  /** Materials made from the fields of ObjectRenderers, shared where the values are equal. */
  readonly materials = new MaterialCache(this);
  /** Users of shared geometries and textures. */
  readonly uses = new UseCounter();

  private readonly sources = new Map<string, AssetSource>();
  private readonly values = new Map<string, Asset>();
  private readonly loading = new Map<string, Promise<Asset>>();
  /** For each name what is derived from the asset: normals by crease angle, textures by repeat. */
  private readonly variants = new Map<string, Map<number, Asset>>();
  private readonly listeners = new Set<(change: AssetChange) => void>();
  private readonly readBytes: FetchBytes;

  constructor(options: AssetLibraryOptions = {}) {
    this.readBytes = options.fetchBytes ?? fetchBytes;
    for (const [name, source] of Object.entries(builtinAssets)) this.sources.set(name, source);
    for (const [name, url] of Object.entries(options.urls ?? {})) this.registerUrl(name, url);
  }

  /** Adds an asset under a new name. @throws AssetError when the name is taken */
  register(name: string, asset: Asset): this {
    this.checkFree(name);
    const type = assetTypeOf(asset);
    this.sources.set(name, { type, make: () => asset });
    this.values.set(name, asset);
    this.tell({ kind: 'registered', name, type });
    return this;
  }

  /** Adds an asset that is made when it is first needed. @throws AssetError when the name is taken */
  registerMaker(name: string, type: AssetType, make: () => Asset): this {
    this.checkFree(name);
    this.sources.set(name, { type, make });
    this.tell({ kind: 'registered', name, type });
    return this;
  }

  /**
   * Adds an asset that `load` reads from an address (PLY meshes, gzip or not; images), or gives 'dragon' its address.
   * @throws AssetError when the name is taken, or the type cannot be told
   */
  registerUrl(name: string, url: string, type: AssetType | null = typeOfUrl(url)): this {
    if (this.sources.get(name) !== builtinAssets.dragon) this.checkFree(name);
    const dragon = name === 'dragon';
    const known = dragon ? 'mesh' : type;
    if (known !== 'mesh' && known !== 'texture') {
      throw new AssetError(name, `cannot be read from '${url}': only .ply, .ply.gz, .png, .jpg and .webp can.`);
    }
    this.sources.set(name, {
      type: known,
      url,
      load: () => loadAsset(url, known, this.readBytes, { normalise: dragon }),
    });
    this.tell({ kind: 'registered', name, type: known });
    return this;
  }

  /** Takes an asset that was added away again; what uses it keeps it. The asset itself is not disposed. */
  unregister(name: string): void {
    const source = this.sources.get(name);
    if (!source) return;
    this.sources.delete(name);
    this.values.delete(name);
    this.variants.delete(name);
    this.tell({ kind: 'removed', name, type: source.type });
  }

  /** Names of all assets of a type, built-in ones first. */
  list(type?: AssetType): string[] {
    return [...this.sources].filter(([, source]) => !type || source.type === type).map(([name]) => name);
  }

  has(name: string, type?: AssetType): boolean {
    const source = this.sources.get(name);
    return source !== undefined && (!type || source.type === type);
  }

  typeOf(name: string): AssetType | null {
    return this.sources.get(name)?.type ?? null;
  }

  /** The address that an asset was registered with, or null. */
  urlOf(name: string): string | null {
    const source = this.sources.get(name);
    return (source && 'url' in source && source.url) || null;
  }

  /** Null when `name` is an asset of this type, else what is wrong: "names the mesh 'x', which is unknown; …". */
  problemWith(type: AssetType, name: string): string | null {
    const source = this.sources.get(name);
    if (source?.type === type) return null;
    if (source) return `names '${name}', which is a ${source.type}: a ${type} is needed.`;
    const known = this.list(type);
    const choices = known.length > 0 ? `known: ${sample(known)}` : `there is no ${type} yet`;
    return `names the ${type} '${name}', which is unknown (${choices}): register it with the AssetLibrary first.`;
  }

  /** Whether the asset can be had at once. */
  isReady(type: AssetType, name: string): boolean {
    const source = this.sources.get(name);
    return source?.type === type && (this.values.has(name) || 'make' in source);
  }

  /** The asset. @throws AssetError naming it when it is unknown or not loaded yet */
  get(name: string): Asset {
    const value = this.values.get(name);
    if (value) return value;
    const source = this.sources.get(name);
    if (!source) throw new AssetError(name, `is unknown: register it first, or choose one of ${sample(this.list())}.`);
    if (!('make' in source)) throw new AssetError(name, `is not loaded yet: await assets.load('${name}') first.`);
    const made = source.make();
    this.values.set(name, made);
    return made;
  }

  /** The asset, loaded if need be. @throws AssetError (as a rejection) when it is unknown or cannot be loaded */
  load(name: string): Promise<Asset> {
    const source = this.sources.get(name);
    if (this.values.has(name) || !source || 'make' in source) {
      return Promise.resolve().then(() => this.get(name));
    }
    const started = this.loading.get(name);
    if (started) return started;
    const promise = source.load().then(
      (value) => {
        this.loading.delete(name);
        this.values.set(name, value);
        this.tell({ kind: 'loaded', name, type: source.type });
        return value;
      },
      (cause: unknown) => {
        this.loading.delete(name);
        const reason = cause instanceof Error ? cause.message : String(cause);
        const error = new AssetError(name, `could not be loaded: ${reason}`, { cause });
        this.tell({ kind: 'failed', name, type: source.type, error });
        throw error;
      },
    );
    this.loading.set(name, promise);
    return promise;
  }

  /** Begins to load an asset and calls back once it is there. A failure is told to `onChange` only. */
  whenReady(type: AssetType, name: string, callback: () => void): void {
    if (this.isReady(type, name)) callback();
    else this.load(name).then(callback, () => {});
  }

  /**
   * A mesh's geometry. When the asset has no normals they are computed, faces that meet at less than `creaseAngle`
   * (radians) being smooth; each angle is computed once.
   */
  mesh(name: string, creaseAngle = Math.PI / 6): BufferGeometry {
    const geometry = this.getAs<BufferGeometry>('mesh', name);
    if (geometry.getAttribute('normal')) return geometry;
    const angle = Math.round(creaseAngle * 1e4) / 1e4;
    return this.variant(name, angle, () => computeCreaseNormals(geometry, angle));
  }

  /** A texture, repeated `repeat` times over each unit of the texture coordinates. */
  texture(name: string, repeat = 1): Texture {
    const texture = this.getAs<Texture>('texture', name);
    if (repeat === 1) return texture;
    return this.variant(name, repeat, () => {
      const copy = texture.clone();
      copy.wrapS = copy.wrapT = RepeatWrapping;
      copy.repeat.copy(texture.repeat).multiplyScalar(repeat);
      return copy;
    });
  }

  material(name: string): Material {
    return this.getAs<Material>('material', name);
  }

  shader(name: string): Material {
    return this.getAs<Material>('shader', name);
  }

  /** Calls `listener` when an asset is registered, loaded, removed or fails. @returns a function that ends it */
  onChange(listener: (change: AssetChange) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /** Gives back the GPU memory of every asset, and forgets them. */
  dispose(): void {
    this.materials.dispose();
    for (const variants of this.variants.values()) for (const each of variants.values()) each.dispose();
    for (const value of this.values.values()) value.dispose();
    this.variants.clear();
    this.values.clear();
    this.sources.clear();
    this.listeners.clear();
  }

  private getAs<T extends Asset>(type: AssetType, name: string): T {
    const problem = this.has(name) && !this.has(name, type) ? `is a ${this.typeOf(name)}: a ${type} is needed.` : null;
    if (problem) throw new AssetError(name, problem);
    return this.get(name) as T;
  }

  private variant<T extends Asset>(name: string, parameter: number, make: () => T): T {
    let variants = this.variants.get(name);
    if (!variants) this.variants.set(name, (variants = new Map()));
    let made = variants.get(parameter) as T | undefined;
    if (!made) variants.set(parameter, (made = make()));
    return made;
  }

  private checkFree(name: string): void {
    if (!name) throw new AssetError(name, 'needs a name.');
    if (this.sources.has(name)) throw new AssetError(name, 'is there already: choose another name.');
  }

  private tell(change: AssetChange): void {
    for (const listener of this.listeners) listener(change);
  }
}
