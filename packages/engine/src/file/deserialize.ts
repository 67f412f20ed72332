import type { AssetLibrary } from '../assets/AssetLibrary';
import { builtinComponents } from '../components/builtinComponents';
import type { ComponentRegistry } from '../components/ComponentRegistry';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { assetUses } from './assetUses';
import type { FarolFile, FileObject } from './FarolFile';
import { FileError, type FileProblem } from './FileError';
import { parseFile } from './parseFile';

export interface DeserializeOptions {
  /** Where the assets come from; a library of the scene's own when absent. */
  assets?: AssetLibrary;
  registry?: ComponentRegistry;
}

/** One GameObject without its children and parent, from checked data. */
function makeObject(data: FileObject, registry: ComponentRegistry): GameObject {
  const gameObject = new GameObject(data.name, { id: data.id });
  gameObject.tags = data.tags ?? [];
  for (const { type, id, enabled, values } of data.components) {
    if (type === 'Transform') {
      for (const name of Object.keys(values)) gameObject.transform.set(name, values[name]);
      gameObject.transform.enabled = enabled ?? true;
      continue;
    }
    gameObject.addComponent(registry.create(type, values), {}, { id, enabled });
  }
  gameObject.active = data.active ?? true;
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
function registerAssets(file: FarolFile, assets: AssetLibrary): string[] {
  const missing = file.assets.filter(({ name }) => !assets.has(name));
  for (const { name, type, url } of missing) assets.registerUrl(name, url, type);
  return missing.map(({ name }) => name);
}

async function loadAssets(file: FarolFile, registry: ComponentRegistry, assets: AssetLibrary): Promise<void> {
  const uses = new Map(assetUses(file, registry).map((use) => [use.name, use.path]));
  const results = await Promise.allSettled([...uses.keys()].map((name) => assets.load(name)));
  const paths = [...uses.values()];
  const problems = results.flatMap((result, i): FileProblem[] =>
    result.status === 'rejected'
      ? [{ path: paths[i], problem: `needs an asset: ${(result.reason as Error).message}` }]
      : [],
  );
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
    registered = registerAssets(checked, scene.assets);
    await loadAssets(checked, registry, scene.assets);
    scene.name = checked.name;
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
