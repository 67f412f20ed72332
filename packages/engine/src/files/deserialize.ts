import { shortText } from '@farol/editing';
import type { AssetError } from '../assets/AssetError';
import type { AssetLibrary } from '../assets/AssetLibrary';
import type { FieldAssetType } from '../assets/FieldAsset';
import { AddressRefusedError } from '../assets/foreignOrigin';
import { typeOfUrl } from '../assets/loadAsset';
import { registerMeshPacks } from '../assets/meshPacks';
import { builtinComponents } from '../components/index';
import { loadBakeCode } from '../core/baked/bakeCode';
import { cancellable } from '../base/cancellable';
import { isCameraComponent } from '../core/CameraComponent';
import type { ComponentRegistry } from '../core/ComponentRegistry';
import { Scene } from '../core/Scene';
import { assetUses, type AssetUse } from './assetUses';
import { OwnAssets } from './OwnAssets';
import type { FarolFile } from './FarolFile';
import { FileError } from '../guard/FileError';
import { type ForeignAddress, foreignAddresses } from './foreignAddresses';
import { makeObjects } from './makeObjects';
import { checkAssets, missingAssets, readFile } from './parseFile';
import { ProblemList } from './ProblemList';

/** Assets, registry and file access that `deserialize` uses. */
export interface DeserializeOptions {
  /** Library for the scene's assets; the scene makes a library of its own when absent. */
  assets?: AssetLibrary;
  registry?: ComponentRegistry;
  /** Returns the bytes of a file of the scene's container, such as 'assets/robot.glb'; null when it has none. */
  fileOf?: (path: string) => Blob | null;
  /**
   * Called once, before any fetch, when the file names addresses of other origins. Returns true for all, false for
   * none, or the origins allowed; from then on the library fetches from those only. A refused asset is not loaded, and
   * `assets.onChange` gets an AddressRefusedError; the rest of the scene opens. Without `mayFetch`, all are fetched.
   */
  mayFetch?: (addresses: readonly ForeignAddress[]) => MayFetch | Promise<MayFetch>;
  /** Cancels opening: the scene is disposed of, and loads that only the scene needs are aborted. */
  signal?: AbortSignal;
}

/** Foreign origins that may be fetched from: true for all that were asked for, false for none, or a list. */
export type MayFetch = boolean | Iterable<string>;

/** Registers the file's own assets that the library lacks, and adds their names to `registered`. */
async function registerAssets(
  file: FarolFile,
  assets: AssetLibrary,
  fileOf: (path: string) => Blob | null,
  registered: string[],
): Promise<void> {
  const inline = await readInline(file);
  const problems = new ProblemList();
  file.assets.forEach(({ name, type, url, file: path, values }, i) => {
    if (assets.has(name)) return;
    if (values) {
      assets.addFieldAsset(type as FieldAssetType, name, values);
      registered.push(name);
      return;
    }
    const blob = path === undefined ? inline.get(name) : fileOf(path);
    if (path !== undefined && !blob) {
      const problem = `names '${shortText(path)}', which did not come with the scene: open the .farol file that holds both.`;
      problems.add(`assets[${i}].file`, problem);
      return;
    }
    try {
      if (blob) assets.registerFile(name, blob, typeOfUrl(name) ?? type);
      else assets.registerUrl(name, url ?? '', type);
      registered.push(name);
    } catch (error) {
      problems.add(`assets[${i}]`, (error as AssetError).problem);
      return;
    }
    const own = assets.typeOf(name);
    if (own !== type)
      problems.add(`assets[${i}].type`, `says ${type}, but its name is that of a ${own}: correct one of them.`);
  });
  problems.throwIfAny();
}

/** The bytes of a `data:` address. @throws FileError naming the asset when it is damaged */
async function readInline(file: FarolFile): Promise<Map<string, Blob>> {
  const blobs = new Map<string, Blob>();
  for (const [i, { name, url }] of file.assets.entries()) {
    if (!url?.startsWith('data:')) continue;
    try {
      blobs.set(name, await (await fetch(url)).blob());
    } catch (cause) {
      const problem = `holds the bytes of '${shortText(name)}' as damaged base64: open another copy of the file.`;
      throw new FileError([{ path: `assets[${i}].url`, problem }], { cause });
    }
  }
  return blobs;
}

async function loadAssets(
  file: FarolFile,
  uses: readonly AssetUse[],
  assets: AssetLibrary,
  signal?: AbortSignal,
): Promise<void> {
  const own = new OwnAssets(file.assets);
  /** Asset whose loading makes a name known: the model for a name of its part, else the asset itself. */
  const loadedFor = (name: string): string => (assets.has(name) ? name : (own.find(name)?.name ?? name));
  const needed = new Map(uses.map((use) => [loadedFor(use.name), use]));
  // field assets need no loading: a material is made when first drawn, after its textures are loaded
  const names = [...needed.keys()].filter((name) => !assets.fieldAsset(name));
  const loads = Promise.allSettled(names.map((name) => assets.load(name, signal)));
  const results = await cancellable(loads, signal, () => {});
  signal?.throwIfAborted();
  const problems = new ProblemList();
  const refused = new Set<string>();
  results.forEach((result, i) => {
    if (result.status === 'fulfilled') return;
    const { reason } = result as { reason: Error };
    if (reason instanceof AddressRefusedError) refused.add(names[i]);
    else problems.add(needed.get(names[i])!.path, `needs an asset: ${reason.message}`);
  });
  problems.throwIfAny();
  for (const use of uses) {
    const { type, name } = use;
    const model = assets.has(name) ? name : loadedFor(name);
    if (model !== name && refused.has(model)) assets.registerPart(name, type, model);
    const problem = assets.problemWith(type, name);
    if (problem) problems.add(use.path, problem);
    if (problems.isFull) break;
  }
  problems.throwIfAny();
}

/** Asks whether the foreign addresses of a file may be fetched. @returns the allowed origins; null for every origin */
async function allowedOrigins(file: FarolFile, { mayFetch }: DeserializeOptions): Promise<ReadonlySet<string> | null> {
  if (!mayFetch) return null;
  const addresses = foreignAddresses(file);
  const answer = addresses.length > 0 && (await mayFetch(addresses));
  if (typeof answer !== 'boolean') return new Set(answer);
  return new Set(answer ? addresses.map(({ origin }) => origin) : []);
}

/**
 * Makes a scene from a file, completely or not at all. Waits for the assets in use, the normals of their meshes, and
 * the sky.
 * @param file - a FarolFile, JSON text, or parsed JSON; always checked
 * @throws FileError (as a rejection) listing everything that is wrong, see `parseFile`; the signal's abort reason
 */
export async function deserialize(file: unknown, options: DeserializeOptions = {}): Promise<Scene> {
  const { signal } = options;
  const registry = options.registry ?? builtinComponents;
  const scene = new Scene({ assets: options.assets, registry });
  const registered: string[] = [];
  const originsBefore = scene.assets.allowedOrigins;
  try {
    const problems = new ProblemList();
    const checked = readFile(file, registry, problems);
    const uses = assetUses(checked, registry);
    if (missingAssets(checked, uses, scene.assets).some(({ type, name }) => type === 'mesh' && name.includes('/')))
      registered.push(...(await registerMeshPacks(scene.assets)));
    checkAssets(checked, uses, scene.assets, problems);
    problems.throwIfAny();
    const origins = await allowedOrigins(checked, options);
    if (options.mayFetch) scene.assets.allowedOrigins = origins;
    await registerAssets(checked, scene.assets, options.fileOf ?? (() => null), registered);
    signal?.throwIfAborted();
    await loadAssets(checked, uses, scene.assets, signal);
    if (checked.settings.bakedLight) await loadBakeCode();
    scene.name = checked.name;
    for (const folder of checked.assetFolders ?? []) scene.assets.setFolder(folder, true);
    for (const prefab of checked.prefabs ?? []) scene.prefabs.set(prefab);
    for (const root of makeObjects(checked.objects, registry)) scene.add(root);
    for (const [name, text] of Object.entries(checked.microShaders ?? {})) scene.microShaders.set(name, text);
    for (const { place, ...view } of checked.views ?? []) scene.views.set(place, view);
    scene.picture = checked.picture ?? null;
    for (const name of Object.keys(checked.settings)) scene.settings.set(name, checked.settings[name]);
    const camera = checked.activeCamera === null ? null : scene.findById(checked.activeCamera);
    scene.activeCamera = camera?.components.find(isCameraComponent) ?? null;
    await cancellable(Promise.all([scene.assets.meshesPrepared(), scene.settings.skyReady]), signal, () => {});
    return scene;
  } catch (error) {
    for (const name of registered) scene.assets.unregister(name);
    scene.assets.allowedOrigins = originsBefore;
    scene.dispose();
    throw error;
  }
}
