import { shortText } from '@farol/editing';
import type { AssetType } from '@farol/editing/fields';
import type { WebGLRenderer } from 'three';
import { cancellable } from '../base/cancellable';
import { type Asset, type AssetMemory, assetTypeOf } from './Asset';
import { AssetError } from './AssetError';
import { builtinAssets } from './builtinAssets';
import {
  type FetchBytes,
  fetchBytes,
  type FileAssetType,
  isFileAssetType,
  readableEndings,
  type ReadOptions,
  typeOfUrl,
} from './loadAsset';
import { AddressRefusedError, foreignOrigin } from './foreignOrigin';
import { Model } from './Model';
import { modelParts } from './modelParts';
import { AssetTable, sample } from './AssetTable';

/** Options of the constructor of AssetLibrary. */
export interface AssetLibraryOptions {
  /** Addresses of new assets by name; the extension of an address gives the type. */
  urls?: Readonly<Record<string, string>>;
  /** Reads the bytes of an address; `fetch` when absent. */
  fetchBytes?: FetchBytes;
  /** Renderer whose device's compressed texture formats are used; nothing is drawn with it. */
  renderer?: WebGLRenderer;
}

/** Reads an asset from its bytes, by readers that are late code. */
async function read(
  bytes: Promise<ArrayBuffer>,
  path: string,
  type: FileAssetType,
  options: ReadOptions,
): Promise<Asset> {
  const [{ readAsset }, given] = await Promise.all([import('./readAsset'), bytes]);
  if (options.memory) options.memory.own.file = given.byteLength;
  return readAsset(given, path, type, options);
}

/** Assets that are made or read on first use, each once; loading a model adds its parts. */
export abstract class LoadedAssets extends AssetTable {
  /**
   * Origins besides the page's that assets may be fetched from, as `foreignOrigin` writes them; null for any, which is
   * the default. Other addresses throw an AddressRefusedError. The addresses in `options.urls` are the host's own, and
   * always allowed. See `mayFetch` of `deserialize`.
   */
  allowedOrigins: ReadonlySet<string> | null = null;

  protected readonly values = new Map<string, Asset>();
  protected readonly loading = new Map<string, Promise<Asset>>();
  /** Names of assets refused for their address, so that each is reported once. */
  protected readonly refused = new Set<string>();
  /** Addresses given in `options.urls`, which are fetched without asking the user. */
  private readonly trusted: ReadonlySet<string>;
  private readonly readBytes: FetchBytes;
  private readonly renderer: WebGLRenderer | null;

  constructor(options: AssetLibraryOptions = {}) {
    super();
    this.readBytes = options.fetchBytes ?? fetchBytes;
    this.renderer = options.renderer ?? null;
    this.trusted = new Set(Object.values(options.urls ?? {}));
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

  /**
   * Adds an asset that `make` creates on first use; it counts as built in.
   * @throws AssetError when the name is taken
   */
  registerMaker(name: string, type: AssetType, make: () => Asset): this {
    this.checkFree(name);
    this.sources.set(name, { type, make, isBuiltin: true });
    this.tell({ kind: 'registered', name, type });
    return this;
  }

  /**
   * Adds an asset that `load` reads from an address (glTF of one file, PLY meshes, gzip or not, images, HDR, EXR, IES,
   * sounds).
   * @throws AssetError when the name is taken, or the type is unknown
   */
  registerUrl(name: string, url: string, type: AssetType | null = typeOfUrl(url)): this {
    this.checkFree(name);
    if (!isFileAssetType(type))
      throw new AssetError(name, `cannot be read from '${shortText(url, 80)}': only ${readableEndings} can.`);
    const { renderer } = this;
    const memory = this.newMemory();
    const load = (signal?: AbortSignal): Promise<Asset> =>
      read(this.fetchFor(name, url), url, type, { renderer, memory, signal });
    this.sources.set(name, { type, url, load, memory: memory.own });
    this.tell({ kind: 'registered', name, type });
    return this;
  }

  /**
   * Adds an asset that is read from the bytes of a file. Its name tells the format: 'robot.glb', 'brick.png',
   * 'sky.hdr', 'door.ogg'. A model brings its meshes, materials and textures along as parts, 'robot.glb/mesh-1-Head',
   * once it is loaded.
   * @param type - told by the name's ending when absent
   * @throws AssetError when the name is taken, or its ending is unknown
   */
  registerFile(name: string, file: Blob, type: AssetType | null = typeOfUrl(name)): this {
    this.checkFree(name);
    if (!isFileAssetType(type))
      throw new AssetError(name, `cannot be read: only ${readableEndings} can. Convert it to one of them.`);
    const { renderer } = this;
    const memory = this.newMemory(file.size);
    const load = (signal?: AbortSignal): Promise<Asset> =>
      read(file.arrayBuffer(), name, type, { renderer, memory, signal });
    this.sources.set(name, { type, file, load, memory: memory.own });
    this.tell({ kind: 'registered', name, type });
    return this;
  }

  /** Whether the asset is available at once. */
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

  /**
   * The asset, loaded if need be.
   * @param signal - signal of the first caller, which cancels the loading for all callers
   * @throws AssetError (as a rejection) when the asset is unknown or cannot be loaded; the signal's abort reason
   */
  load(name: string, signal?: AbortSignal): Promise<Asset> {
    const source = this.sources.get(name);
    if (this.values.has(name) || !source || 'make' in source) {
      return Promise.resolve().then(() => this.get(name));
    }
    const started = this.loading.get(name);
    if (started) return started;
    const promise = cancellable(source.load(signal), signal, (late) => late.dispose()).then(
      (value) => {
        this.loading.delete(name);
        // not stored, as the asset was removed or replaced while loading
        if (this.sources.get(name) !== source) return value;
        this.values.set(name, value);
        if (value instanceof Model) this.registerParts(name, value);
        this.tell({ kind: 'loaded', name, type: source.type });
        return value;
      },
      (cause: unknown) => {
        this.loading.delete(name);
        signal?.throwIfAborted();
        if (cause instanceof AddressRefusedError) throw this.refusal(name, source.type, cause);
        const reason = cause instanceof Error ? cause.message : String(cause);
        const error = new AssetError(name, `could not be loaded: ${reason}`, { cause });
        this.tell({ kind: 'failed', name, type: source.type, error });
        throw error;
      },
    );
    this.loading.set(name, promise);
    return promise;
  }

  /** Loads an asset if necessary, and calls back when it is available. A failure is reported to `onChange` only. */
  whenReady(type: AssetType, name: string, callback: () => void): void {
    if (this.isReady(type, name)) callback();
    else this.load(name).then(callback, () => {});
  }

  /** Name of an asset that was made or loaded; null when the library does not have it. */
  nameOf(asset: Asset): string | null {
    for (const [name, value] of this.values) if (value === asset) return name;
    return null;
  }

  /**
   * Registers the name of a part of a model that is not loaded, for scenes whose model was refused; the part becomes
   * available once the model is loaded.
   * @internal
   */
  registerPart(name: string, type: AssetType, model: string): void {
    this.checkFree(name);
    const load = async (): Promise<Asset> => {
      await this.load(model);
      return this.getAs(type, name);
    };
    this.sources.set(name, { type, load, partOf: model });
    this.addPart(model, name);
    this.tell({ kind: 'registered', name, type });
  }

  protected getAs<T extends Asset>(type: AssetType, name: string): T {
    const problem = this.has(name) && !this.has(name, type) ? `is a ${this.typeOf(name)}: a ${type} is needed.` : null;
    if (problem) throw new AssetError(name, problem);
    return this.get(name) as T;
  }

  /** Begins the memory account of an asset. @param file - size of its file (bytes), if known */
  protected newMemory(file = 0): NonNullable<ReadOptions['memory']> {
    const all = (): AssetMemory[] =>
      [...this.sources.values()].flatMap((source) => ('memory' in source && source.memory) || []);
    return { own: { file, decoded: new Map() }, all };
  }

  /** @throws AddressRefusedError (as a rejection) before any request */
  protected async fetchFor(name: string, url: string): Promise<ArrayBuffer> {
    const isAsked = this.allowedOrigins !== null && !this.trusted.has(url);
    const origin = isAsked ? foreignOrigin(url) : null;
    const isLimited = origin !== null;
    if (isLimited && !this.allowedOrigins!.has(origin)) throw new AddressRefusedError(name, url, origin);
    return this.readBytes(url, { isLimited, staysHere: isAsked && !isLimited });
  }

  protected refusal(name: string, type: AssetType, error: AddressRefusedError): AddressRefusedError {
    if (!this.refused.has(name)) {
      this.refused.add(name);
      this.tell({ kind: 'failed', name, type, error });
    }
    return error;
  }

  protected registerParts(name: string, model: Model): void {
    for (const [asset, part] of modelParts(model, name)) {
      const known = this.sources.get(part);
      // a part registered before the model was loaded is replaced
      if (known && !('load' in known && 'partOf' in known)) continue;
      this.sources.set(part, { type: assetTypeOf(asset), make: () => asset, partOf: name });
      this.addPart(name, part);
      this.values.set(part, asset);
    }
  }
}
