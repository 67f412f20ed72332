import { shortText } from '@farol/editing';
import type { AssetType, FieldValue } from '@farol/editing/fields';
import {
  BufferGeometry,
  type Material,
  NoColorSpace,
  RepeatWrapping,
  SRGBColorSpace,
  type Texture,
  type WebGLRenderer,
} from 'three';
import type { BakedLight } from './bake/BakedLight';
import { cancellable } from '../base/cancellable';
import {
  type Asset,
  type AssetChange,
  type AssetFile,
  type AssetMemory,
  type AssetSource,
  assetTypeOf,
  type MaterialUser,
  type TakenAsset,
} from './Asset';
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
import { ClipAsset } from './clips/ClipAsset';
import type { FieldAsset, FieldAssetType } from './FieldAsset';
import { LayeredMaterials } from './LayeredMaterials';
import { MaterialAsset, type MaterialHost } from './MaterialAsset';
import { MaterialCache } from './MaterialCache';
import { MeshNormals } from './MeshNormals';
import { Model, type ModelClip } from './Model';
import { modelParts } from './modelParts';
import { ScriptAsset } from './ScriptAsset';
import type { PhotometricProfile } from '@farol/renderer/light-profiles';
import type { Sound } from './Sound';
import { SurfaceAsset, type SurfaceHost } from './SurfaceAsset';
import { UseCounter } from './UseCounter';

/** Crease angle of meshes where none is given (radians). */
const DEFAULT_CREASE = Math.PI / 6;

export interface AssetLibraryOptions {
  /**
   * Addresses of assets by name: 'dragon' gets a PLY (may be gzip) in place of the one made in code; other names become
   * new assets, their type told by the ending of the address.
   */
  urls?: Readonly<Record<string, string>>;
  /** How the bytes of an address are read; `fetch` when absent. */
  fetchBytes?: FetchBytes;
  /** What will draw the assets: asked only for which compressed textures the device takes. */
  renderer?: WebGLRenderer;
}

/** Nearest thing that was meant, for messages: at most eight names of the type. */
const sample = (names: readonly string[]): string =>
  names
    .slice(0, 8)
    .map((name) => shortText(name, 24))
    .join(', ') + (names.length > 8 ? ', …' : '');

/** Reads an asset from its bytes; what reads them is fetched meanwhile, and is no part of what a first frame needs. */
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

/** The meshes, textures, materials and shaders that scenes name. Built-in ones are made on demand. */
export class AssetLibrary implements MaterialHost, SurfaceHost {
  /** Materials made from the fields of ObjectRenderers, shared where the values are equal. */
  readonly materials = new MaterialCache(this);
  /** @internal Materials of objects that wear a surface by themselves. */
  readonly layered = new LayeredMaterials(this);
  /** Time (s) of the scene, by which surfaces move. */
  readonly surfaceTime = { value: 0 };
  /** Users of shared geometries and textures. */
  readonly uses = new UseCounter();

  /**
   * Origins besides the page's that assets may be fetched from, as `foreignOrigin` writes them; null for any, which is the
   * default. What leads elsewhere is refused by an AddressRefusedError. The addresses in `options.urls` are the host's own,
   * and always allowed. See `mayFetch` of `deserialize`.
   */
  allowedOrigins: ReadonlySet<string> | null = null;

  private readonly sources = new Map<string, AssetSource>();
  private readonly values = new Map<string, Asset>();
  private readonly loading = new Map<string, Promise<Asset>>();
  private readonly normals = new MeshNormals();
  /** Textures by repeat and by whether they are data, for each name. */
  private readonly repeated = new Map<string, Map<string, Texture>>();
  /** Names of parts by that of their model; some may be gone. */
  private readonly parts = new Map<string, Set<string>>();
  private readonly listeners = new Set<(change: AssetChange) => void>();
  private readonly materialUsers = new Map<string, Set<MaterialUser>>();
  private readonly ownFolders = new Set<string>();
  /** Names of those that were refused for their address, so that each is told once. */
  private readonly refused = new Set<string>();
  /** Addresses that the host gave. */
  private readonly trusted: ReadonlySet<string>;
  private readonly readBytes: FetchBytes;
  private readonly renderer: WebGLRenderer | null;

  constructor(options: AssetLibraryOptions = {}) {
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
   * Adds an asset that code makes when it is first needed; it counts as built in.
   * @throws AssetError when the name is taken
   */
  registerMaker(name: string, type: AssetType, make: () => Asset): this {
    this.checkFree(name);
    this.sources.set(name, { type, make, isBuiltin: true });
    this.tell({ kind: 'registered', name, type });
    return this;
  }

  /**
   * Adds an asset that `load` reads from an address (glTF of one file, PLY meshes, gzip or not, images, HDR, EXR, IES, sounds), or gives
   * 'dragon' its address.
   * @throws AssetError when the name is taken, or the type cannot be told
   */
  registerUrl(name: string, url: string, type: AssetType | null = typeOfUrl(url)): this {
    if (this.sources.get(name) !== builtinAssets.dragon) this.checkFree(name);
    const dragon = name === 'dragon';
    const known = dragon ? 'mesh' : type;
    if (!isFileAssetType(known)) {
      throw new AssetError(name, `cannot be read from '${shortText(url, 80)}': only ${readableEndings} can.`);
    }
    const options: ReadOptions = { normalise: dragon, renderer: this.renderer, memory: this.newMemory() };
    const load = (signal?: AbortSignal): Promise<Asset> =>
      read(this.fetchFor(name, url), url, known, { ...options, signal });
    this.sources.set(name, { type: known, url, load, memory: options.memory!.own });
    this.tell({ kind: 'registered', name, type: known });
    return this;
  }

  /**
   * Adds an asset that is read from the bytes of a file. Its name tells the format: 'robot.glb', 'brick.png', 'sky.hdr', 'door.ogg'.
   * A model brings its meshes, materials and textures along as parts, 'robot.glb/mesh-1-Head', once it is loaded.
   * @param type - what it is; told by the ending of the name when absent
   * @throws AssetError when the name is taken, or its ending is none that can be read
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

  /**
   * Adds a material that is made of fields, to be shared by objects and edited.
   * @param values - in place of the defaults; textures that they name may come later
   * @throws AssetError when the name is taken; FieldError for a value that is not allowed
   */
  addMaterial(name: string, values: Readonly<Record<string, FieldValue>> = {}): MaterialAsset {
    return this.addFieldAsset('material', name, values) as MaterialAsset;
  }

  /**
   * Adds an asset that is made of fields.
   * @param values - in place of the defaults; what they name may come later
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

  /** The asset of this name that is made of fields; null when it is another one. */
  fieldAsset(name: string): FieldAsset | null {
    const source = this.sources.get(name);
    return (source && 'edited' in source && source.edited) || null;
  }

  /** Every asset that is made of fields, of one type when given. */
  fieldAssets(type?: FieldAssetType): FieldAsset[] {
    return [...this.sources.values()].flatMap((source) =>
      'edited' in source && source.edited && (!type || source.type === type) ? source.edited : [],
    );
  }

  /** The material of this name whose fields can be edited; null when it is another asset, or one of a model. */
  materialAsset(name: string): MaterialAsset | null {
    const asset = this.fieldAsset(name);
    return asset?.type === 'material' ? (asset as MaterialAsset) : null;
  }

  /** Every material whose fields can be edited. */
  get materialAssets(): MaterialAsset[] {
    return this.fieldAssets('material') as MaterialAsset[];
  }

  /** Whether anything is in it that a user made or brought: files, materials, folders. */
  get hasOwn(): boolean {
    return this.ownFolders.size > 0 || this.files.length > 0 || this.fieldAssets().length > 0;
  }

  /** Folders that are there without an asset in them too, by path: 'Props', 'Props/Lamps'. */
  get folders(): string[] {
    return [...this.ownFolders].toSorted();
  }

  /** Adds a folder, or takes it out; assets have their folder in their name, 'Props/robot.glb'. @throws AssetError for a path that is none */
  setFolder(path: string, isThere: boolean): void {
    if (path.split('/').some((part) => part.trim() === '')) throw new AssetError(path, 'is no path of a folder.');
    if (this.ownFolders.has(path) === isThere) return;
    if (isThere) this.ownFolders.add(path);
    else this.ownFolders.delete(path);
    this.tell({ kind: 'folder', name: path });
  }

  /**
   * Gives an asset another name, its parts with it. What names it is to be told: see `fields`.
   * @returns the new name of everything that got one, by the old one
   * @throws AssetError when it is built in, a part of a model or unknown, or the name is taken
   */
  rename(from: string, to: string): Map<string, string> {
    const source = this.sources.get(from);
    if (!source) throw new AssetError(from, 'is unknown: it is gone already.');
    if (this.isBuiltin(from)) throw new AssetError(from, 'came with Farol, and keeps its name.');
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

  /** Tells a user of a material when it becomes another one. */
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

  /** The surface of this name; null when there is none. */
  surface(name: string): SurfaceAsset | null {
    const asset = this.fieldAsset(name);
    return asset?.type === 'surface' ? (asset as SurfaceAsset) : null;
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

  /** @internal What a material draws has another shape: its users are to look at it again. */
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

  /** The model that an asset is a part of; null when it is none. */
  modelOf(name: string): string | null {
    const source = this.sources.get(name);
    return (source && 'partOf' in source && source.partOf) || null;
  }

  /** The assets that came with a model. */
  partsOf(name: string): string[] {
    return [...(this.parts.get(name) ?? [])].filter((part) => this.modelOf(part) === name);
  }

  /** Whether an asset came with the library, as the box did, or with a scene by `registerMaker`. */
  isBuiltin(name: string): boolean {
    const source = this.sources.get(name);
    return (
      Object.hasOwn(builtinAssets, name) || (source !== undefined && 'make' in source && source.isBuiltin === true)
    );
  }

  /**
   * Takes an asset, with its parts, out in such a way that `restore` can put it back; what uses it keeps it.
   * @throws AssetError when there is none of this name
   */
  take(name: string): TakenAsset {
    const source = this.sources.get(name);
    if (!source) throw new AssetError(name, 'is unknown: it is gone already.');
    const parts = this.partsOf(name).map((part) => this.take(part));
    const value = this.values.get(name);
    this.unregister(name);
    return { name, source, value, parts };
  }

  /** Puts back what `take` took. @throws AssetError when the name is taken meanwhile */
  restore({ name, source, value, parts }: TakenAsset): void {
    this.checkFree(name);
    this.sources.set(name, source);
    if ('partOf' in source && source.partOf !== undefined) this.addPart(source.partOf, name);
    if (value) this.values.set(name, value);
    for (const part of parts) this.restore(part);
    this.tell({ kind: 'registered', name, type: source.type });
    if (source.type === 'surface') this.surface(name)?.begin();
  }

  /** Takes an asset that was added, with its parts, away again; what uses it keeps it. The asset itself is not disposed. */
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
    if (source) return `names '${shortText(name)}', which is a ${source.type}: a ${type} is needed.`;
    const known = this.list(type);
    const choices = known.length > 0 ? `known: ${sample(known)}` : `there is no ${type} yet`;
    return `names the ${type} '${shortText(name)}', which is unknown (${choices}): register it with the AssetLibrary first.`;
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

  /**
   * The asset, loaded if need be.
   * @param signal - of the first who asks: cancels the loading at once, for all who wait for it
   * @throws AssetError (as a rejection) when it is unknown or cannot be loaded; what the signal was aborted with
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
        // it was taken out, or another one came, while it was loading
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

  /** The name of an asset that was made or loaded; null when it is not in the library. */
  nameOf(asset: Asset): string | null {
    for (const [name, value] of this.values) if (value === asset) return name;
    return null;
  }

  /** Begins to load an asset and calls back once it is there. A failure is told to `onChange` only. */
  whenReady(type: AssetType, name: string, callback: () => void): void {
    if (this.isReady(type, name)) callback();
    else this.load(name).then(callback, () => {});
  }

  /**
   * A mesh's geometry. When the asset has no normals they are computed, faces that meet at less than `creaseAngle`
   * (radians) being smooth; each angle is computed once. Of a large mesh that takes seconds: see `prepareMesh`.
   */
  mesh(name: string, creaseAngle = DEFAULT_CREASE): BufferGeometry {
    return this.normals.get(this.getAs<BufferGeometry>('mesh', name), creaseAngle);
  }

  /** Whether `mesh` gives this geometry without holding the page for long. */
  isMeshReady(name: string, creaseAngle = DEFAULT_CREASE): boolean {
    return this.isReady('mesh', name) && this.normals.isReady(this.getAs<BufferGeometry>('mesh', name), creaseAngle);
  }

  /**
   * What `mesh` gives, loaded if need be, its normals computed in slices: the page answers meanwhile.
   * @param signal - cancels the wait, and the work when nobody else waits for it
   * @throws AssetError (as a rejection) when it is no mesh or cannot be loaded; what the signal was aborted with
   */
  prepareMesh(name: string, creaseAngle = DEFAULT_CREASE, signal?: AbortSignal): Promise<BufferGeometry> {
    const prepare = (): Promise<BufferGeometry> =>
      this.normals.prepare(this.getAs<BufferGeometry>('mesh', name), creaseAngle, signal);
    return this.isReady('mesh', name) ? prepare() : this.load(name, signal).then(prepare);
  }

  /** Whether nothing is being loaded, and no normals are being computed. */
  get isSettled(): boolean {
    return this.loading.size === 0 && this.normals.isSettled;
  }

  /** Fulfilled when all that is being loaded or computed is there or has failed, and what was asked for meanwhile. */
  async settled(): Promise<void> {
    while (!this.isSettled) await Promise.allSettled([...this.loading.values(), this.normals.settled()]);
  }

  /** Fulfilled when all normals are there that `prepareMesh` computes now. */
  meshesPrepared(): Promise<void> {
    return this.normals.settled();
  }

  /**
   * A texture, repeated `repeat` times over each unit of the texture coordinates.
   * @param isData - its bytes are numbers, such as normals, and no colours of sRGB
   */
  texture(name: string, repeat = 1, isData = false): Texture {
    const texture = this.getAs<Texture>('texture', name);
    const isDecoded = isData && texture.colorSpace === SRGBColorSpace;
    if (repeat === 1 && !isDecoded) return texture;
    let copies = this.repeated.get(name);
    if (!copies) this.repeated.set(name, (copies = new Map()));
    const key = `${repeat}${isDecoded ? ' data' : ''}`;
    let copy = copies.get(key);
    if (!copy) {
      copy = texture.clone();
      if (isDecoded) copy.colorSpace = NoColorSpace;
      if (repeat !== 1) {
        copy.wrapS = copy.wrapT = RepeatWrapping;
        copy.repeat.copy(texture.repeat).multiplyScalar(repeat);
      }
      copies.set(key, copy);
    }
    return copy;
  }

  material(name: string): Material {
    return this.getAs<Material>('material', name);
  }

  model(name: string): Model {
    return this.getAs<Model>('model', name);
  }

  sound(name: string): Sound {
    return this.getAs<Sound>('sound', name);
  }

  /** The photometric profile of a luminaire. */
  profile(name: string): PhotometricProfile {
    return this.getAs<PhotometricProfile>('profile', name);
  }

  /** Light that was baked. */
  bake(name: string): BakedLight {
    return this.getAs<BakedLight>('bake', name);
  }

  /** A clip of one's own, or one of a model. */
  clip(name: string): ClipAsset | ModelClip {
    return this.getAs<ClipAsset | ModelClip>('clip', name);
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

  /**
   * Names a part of a model that is not loaded, as a scene needs it whose model was refused: it is there once the model is.
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

  /** Counts what an asset takes. @param file - bytes of its file, where they are known */
  private newMemory(file = 0): NonNullable<ReadOptions['memory']> {
    const all = (): AssetMemory[] =>
      [...this.sources.values()].flatMap((source) => ('memory' in source && source.memory) || []);
    return { own: { file, decoded: new Map() }, all };
  }

  /** @throws AddressRefusedError (as a rejection) before anything is asked for */
  private async fetchFor(name: string, url: string): Promise<ArrayBuffer> {
    const isAsked = this.allowedOrigins !== null && !this.trusted.has(url);
    const origin = isAsked ? foreignOrigin(url) : null;
    const isLimited = origin !== null;
    if (isLimited && !this.allowedOrigins!.has(origin)) throw new AddressRefusedError(name, url, origin);
    return this.readBytes(url, { isLimited, staysHere: isAsked && !isLimited });
  }

  private refusal(name: string, type: AssetType, error: AddressRefusedError): AddressRefusedError {
    if (!this.refused.has(name)) {
      this.refused.add(name);
      this.tell({ kind: 'failed', name, type, error });
    }
    return error;
  }

  private getAs<T extends Asset>(type: AssetType, name: string): T {
    const problem = this.has(name) && !this.has(name, type) ? `is a ${this.typeOf(name)}: a ${type} is needed.` : null;
    if (problem) throw new AssetError(name, problem);
    return this.get(name) as T;
  }

  private registerParts(name: string, model: Model): void {
    for (const [asset, part] of modelParts(model, name)) {
      const known = this.sources.get(part);
      // one that was named before the model came takes its place
      if (known && !('load' in known && 'partOf' in known)) continue;
      this.sources.set(part, { type: assetTypeOf(asset), make: () => asset, partOf: name });
      this.addPart(name, part);
      this.values.set(part, asset);
    }
  }

  private addPart(model: string, part: string): void {
    const parts = this.parts.get(model);
    if (parts) parts.add(part);
    else this.parts.set(model, new Set([part]));
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

  private checkFree(name: string): void {
    if (!name) throw new AssetError(name, 'needs a name.');
    if (this.sources.has(name)) throw new AssetError(name, 'is there already: choose another name.');
  }

  private tell(change: AssetChange): void {
    for (const listener of this.listeners) listener(change);
  }
}
