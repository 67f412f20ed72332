import type { AssetLibrary } from '../assets/AssetLibrary';
import { builtinComponents } from '../components/builtinComponents';
import type { ComponentRegistry } from '../components/ComponentRegistry';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { assetUses } from './assetUses';
import { OwnAssets } from './OwnAssets';
import type { FarolFile, FileObject } from './FarolFile';
import { FileError, type FileProblem } from './FileError';
import { parseFile } from './parseFile';

export interface DeserializeOptions {
  /** Where the assets come from; a library of the scene's own when absent. */
  assets?: AssetLibrary;
  registry?: ComponentRegistry;
  /** The bytes of a file of the container that the scene came in, such as 'assets/robot.glb'; null when it has none. */
  fileOf?: (path: string) => Blob | null;
}

/** One GameObject without its children and parent, from checked data. */
function makeObject(data: FileObject, registry: ComponentRegistry): GameObject {
  const gameObject = new GameObject(data.name, { id: data.id });
  gameObject.tags = data.tags ?? [];
  gameObject.prefabLink = data.prefab ?? null;
  for (const { type, id, enabled, values } of data.components) {
    if (type === 'Transform') {
      for (const name of Object.keys(values)) gameObject.transform.set(name, values[name]);
      gameObject.transform.enabled = enabled ?? true;
      continue;
    }
    gameObject.addComponent(registry.create(type, values), {}, { id, enabled });
  }
  gameObject.active = data.active ?? true;
  gameObject.locked = data.locked ?? false;
  return gameObject;
}

/** The objects of a checked file, linked; those at the top. Parents may come after their children. */
export function makeObjects(
  objects: readonly FileObject[],
  registry: ComponentRegistry = builtinComponents,
): GameObject[] {
  const byId = new Map(objects.map((data) => [data.id, makeObject(data, registry)]));
  const roots: GameObject[] = [];
  for (const { id, parent } of objects) {
    const gameObject = byId.get(id)!;
    if (parent === null) roots.push(gameObject);
    else byId.get(parent)!.add(gameObject);
  }
  return roots;
}

/** Registers the file's own assets that the library does not have. @returns their names */
async function registerAssets(
  file: FarolFile,
  assets: AssetLibrary,
  fileOf: (path: string) => Blob | null,
): Promise<string[]> {
  const inline = await readInline(file);
  const missing = file.assets.filter(({ name }) => !assets.has(name));
  const blobs = missing.map(({ name, file: path }) => (path === undefined ? (inline.get(name) ?? null) : fileOf(path)));
  const problems = missing.flatMap((asset, i): FileProblem[] =>
    asset.file === undefined || blobs[i]
      ? []
      : [
          {
            path: `assets[${file.assets.indexOf(asset)}].file`,
            problem: `names '${asset.file}', which did not come with the scene: open the .farol file that holds both.`,
          },
        ],
  );
  if (problems.length > 0) throw new FileError(problems);
  missing.forEach(({ name, type, url }, i) => {
    const blob = blobs[i];
    if (blob) assets.registerFile(name, blob);
    else assets.registerUrl(name, url ?? '', type);
  });
  return missing.map(({ name }) => name);
}

/** The bytes of a `data:` address. @throws FileError naming the asset when it is damaged */
async function readInline(file: FarolFile): Promise<Map<string, Blob>> {
  const blobs = new Map<string, Blob>();
  for (const [i, { name, url }] of file.assets.entries()) {
    if (!url?.startsWith('data:')) continue;
    try {
      blobs.set(name, await (await fetch(url)).blob());
    } catch (cause) {
      const problem = `holds the bytes of '${name}' as damaged base64: open another copy of the file.`;
      throw new FileError([{ path: `assets[${i}].url`, problem }], { cause });
    }
  }
  return blobs;
}

async function loadAssets(file: FarolFile, registry: ComponentRegistry, assets: AssetLibrary): Promise<void> {
  const uses = assetUses(file, registry);
  const own = new OwnAssets(file.assets);
  /** What has to be loaded before a name is known: the model of a part, else the asset itself. */
  const loadedFor = (name: string): string => (assets.has(name) ? name : (own.find(name)?.name ?? name));
  const needed = new Map(uses.map((use) => [loadedFor(use.name), use.path]));
  const names = [...needed.keys()];
  const results = await Promise.allSettled(names.map((name) => assets.load(name)));
  const problems = results.flatMap((result, i): FileProblem[] =>
    result.status === 'rejected'
      ? [{ path: needed.get(names[i])!, problem: `needs an asset: ${(result.reason as Error).message}` }]
      : [],
  );
  if (problems.length > 0) throw new FileError(problems);
  for (const { path, type, name } of uses) {
    const problem = assets.problemWith(type, name);
    if (problem) problems.push({ path, problem });
  }
  if (problems.length > 0) throw new FileError(problems);
}

/**
 * Makes a scene of a file: all of it or nothing. Waits for the assets that it names.
 * @param file - a FarolFile, JSON text, or what JSON.parse made of it; it is checked in any case
 * @throws FileError (as a rejection) listing everything that is wrong; see `parseFile`
 */
export async function deserialize(file: unknown, options: DeserializeOptions = {}): Promise<Scene> {
  const registry = options.registry ?? builtinComponents;
  const scene = new Scene({ assets: options.assets, registry });
  let registered: string[] = [];
  try {
    const checked = parseFile(file, { registry, assets: scene.assets });
    registered = await registerAssets(checked, scene.assets, options.fileOf ?? (() => null));
    await loadAssets(checked, registry, scene.assets);
    scene.name = checked.name;
    for (const prefab of checked.prefabs ?? []) scene.prefabs.set(prefab);
    for (const root of makeObjects(checked.objects, registry)) scene.add(root);
    for (const [name, text] of Object.entries(checked.microShaders ?? {})) scene.microShaders.set(name, text);
    for (const name of Object.keys(checked.settings)) scene.settings.set(name, checked.settings[name]);
    const camera = checked.activeCamera === null ? null : scene.findById(checked.activeCamera);
    scene.activeCamera = camera ? (camera.getComponent('Camera') as Scene['activeCamera']) : null;
    return scene;
  } catch (error) {
    for (const name of registered) scene.assets.unregister(name);
    scene.dispose();
    throw error;
  }
}
