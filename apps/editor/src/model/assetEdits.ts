/** Commands for edits of assets. Each captures the scene's state when the command is made. */
import { type Command, type FieldEdit, SetFields, t, tCount } from '@farol/editing';
import {
  type AssetLibrary,
  AssetError,
  type FieldAssetType,
  type ObjectRenderer,
  type Scene,
  type TakenAsset,
} from '@farol/engine';
import { type FieldValue, materialAssetFields, sameValue } from '@farol/engine/fields';
import { canRename, endingOf, freeAssetName, freeNameAmong, joinName, splitName } from './assetNames';
import { AddAssets } from './commands/AddAssets';
import { RenameAsset } from './commands/RenameAsset';
import { Sequence } from './commands/Sequence';
import { setFolder } from './commands/SetValue';
import { SetPrefab } from './commands/SetPrefab';
import { setSources, sourcesAfterRename } from './scriptImports';

type Values = Readonly<Record<string, FieldValue>>;

/** Creates an asset made of fields, not in the library yet. */
export function newFieldAsset(assets: AssetLibrary, type: FieldAssetType, name: string, values: Values): TakenAsset {
  const free = freeAssetName(assets, name);
  assets.addFieldAsset(type, free, values);
  return assets.take(free);
}

/** Adds a material to the library, and assigns it to objects. @returns the command, and the material's name */
export function addMaterial(
  scene: Scene,
  name: string,
  values: Values = {},
  users: readonly ObjectRenderer[] = [],
): { command: Command; name: string } {
  const { assets } = scene;
  const made = newFieldAsset(assets, 'material', name, values);
  const label = t('Made material {name}', { name: made.name });
  const edits = users.flatMap((owner): FieldEdit[] => [
    { owner, name: 'shader', value: null },
    { owner, name: 'material', value: made.name },
  ]);
  const command = new Sequence(label, [
    () => new AddAssets(assets, [made]),
    ...(edits.length > 0 ? [() => new SetFields(label, edits)] : []),
  ]);
  return { command, name: made.name };
}

/** Values of a library material that looks like an object's own material, which is made of the object's fields. */
export function valuesOfOwnMaterial(renderer: ObjectRenderer): Record<string, FieldValue> {
  const values: Record<string, FieldValue> = {};
  for (const [name, field] of Object.entries(materialAssetFields)) {
    if (!(name in renderer.fields) || name === 'material' || name === 'side') continue;
    const value = renderer.getAuthored(name);
    if (!sameValue(value, field.default)) values[name] = value;
  }
  for (const map of ['map', 'normalMap'] as const) {
    if (renderer[map] !== null && renderer.repeat !== 1) {
      values[`${map}RepeatX`] = renderer.repeat;
      values[`${map}RepeatY`] = renderer.repeat;
    }
  }
  return values;
}

/** Copies a material, in the same folder. @throws AssetError when its fields cannot be read */
export function duplicateMaterial(scene: Scene, name: string): { command: Command; name: string } {
  const material = scene.assets.materialAsset(name);
  if (!material) throw new AssetError(name, t('cannot be edited: make a new material.'));
  const made = addMaterial(scene, name, material.changedValues());
  return { ...made, command: withLabel(t('Duplicated {name}', { name }), made.command) };
}

const withLabel = (label: string, command: Command): Command => new Sequence(label, [() => command]);

/** Trims a name. @throws AssetError when the name is not allowed */
function checkedName(assets: AssetLibrary, from: string, to: string): string {
  const name = to
    .split('/')
    .map((part) => part.trim())
    .join('/');
  if (name.split('/').includes('')) throw new AssetError(to, t('needs a name.'));
  const ending = endingOf(from);
  const isFile = assets.fileOf(from) !== null;
  return isFile && ending !== '' && !name.toLowerCase().endsWith(ending.toLowerCase()) ? name + ending : name;
}

/** Renames an asset; the name includes its folder, and a file keeps its extension. @throws AssetError when the name is taken */
export function renameAsset(scene: Scene, from: string, to: string): Command {
  const { assets } = scene;
  const name = checkedName(assets, from, to);
  if (name !== from && assets.has(name)) throw new AssetError(name, t('is there already: choose another name.'));
  const isMove = splitName(name).leaf === splitName(from).leaf;
  const folder = splitName(name).folder || t('the top');
  const label = isMove
    ? t('Moved {name} to {folder}', { name: splitName(from).leaf, folder })
    : t('Renamed {name} to {next}', { name: from, next: name });
  return new RenameAsset(label, scene, from, name);
}

/** Name with the folder of an asset, or of a prefab given by its id. */
const placedName = (scene: Scene, name: string): string => scene.prefabs.get(name)?.name ?? name;

/** Whether an asset, or a prefab given by its id, can be put into a folder. */
export const canMove = (scene: Scene, name: string): boolean =>
  scene.prefabs.get(name) !== null || canRename(scene.assets, name);

/** Puts assets, and prefabs given by their ids, into a folder, '' for none. A name taken there gets a number. */
export function moveAssets(scene: Scene, names: readonly string[], folder: string): Command {
  const moved = names.filter((name) => splitName(placedName(scene, name)).folder !== folder);
  const label = tCount(moved.length, 'Move {count} asset to {folder}', 'Move {count} assets to {folder}', {
    folder: folder || t('the top'),
  });
  const renames = new Map<string, string>();
  for (const name of moved) {
    const leaf = splitName(placedName(scene, name)).leaf;
    if (scene.prefabs.get(name)) {
      renames.set(name, joinName(folder, leaf));
      continue;
    }
    const taken = (wanted: string): boolean => scene.assets.has(wanted) || [...renames.values()].includes(wanted);
    renames.set(name, freeNameAmong(taken, joinName(folder, leaf)));
  }
  return renameAll(scene, label, renames);
}

/** Renames assets, and prefabs given by their ids, to free names; imports in scripts are adapted. */
function renameAll(scene: Scene, label: string, renames: ReadonlyMap<string, string>): Command {
  const ofAssets = new Map([...renames].filter(([name]) => !scene.prefabs.get(name)));
  const ofPrefabs = [...renames].filter(([name]) => scene.prefabs.get(name));
  return new Sequence(label, [
    ...[...ofAssets].map(
      ([from, to]) =>
        () =>
          new RenameAsset(label, scene, from, to),
    ),
    // each command is made only after the renaming of assets: the prefab may refer to an asset that was just renamed
    ...ofPrefabs.map(
      ([id, name]) =>
        () =>
          new SetPrefab(scene, id, { ...scene.prefabs.get(id)!, name }),
    ),
    ...setSources(scene, label, sourcesAfterRename(scene, ofAssets)),
  ]);
}

/** Every folder: those of assets and prefabs, empty ones that were added, and their parents. */
export function foldersOf({ assets, prefabs }: Scene): string[] {
  const folders = new Set<string>();
  const add = (path: string): void => {
    for (let folder = path; folder !== ''; folder = splitName(folder).folder) folders.add(folder);
  };
  for (const path of assets.folders) add(path);
  for (const name of assets.list()) if (canRename(assets, name)) add(splitName(name).folder);
  for (const { name } of prefabs.list) add(splitName(name).folder);
  return [...folders].toSorted();
}

/** The assets in a folder and its subfolders; prefabs as ids. */
export const assetsBelow = ({ assets, prefabs }: Scene, folder: string): string[] => [
  ...assets.list().filter((name) => name.startsWith(`${folder}/`) && canRename(assets, name)),
  ...prefabs.list.filter(({ name }) => name.startsWith(`${folder}/`)).map(({ id }) => id),
];

/** Adds an empty folder. @throws AssetError for a path that is not allowed or exists */
export function addFolder(scene: Scene, path: string): Command {
  const { assets } = scene;
  const name = checkedName(assets, path, path);
  if (foldersOf(scene).includes(name) || assets.has(name))
    throw new AssetError(name, t('is there already: choose another name.'));
  return setFolder(t('Made folder {name}', { name }), assets, name, true);
}

/** Renames a folder with everything in it. @throws AssetError when the path exists */
export function renameFolder(scene: Scene, from: string, to: string): Command {
  const { assets } = scene;
  const path = checkedName(assets, from, to);
  if (foldersOf(scene).includes(path) || assets.has(path))
    throw new AssetError(path, t('is there already: choose another name.'));
  if (path.startsWith(`${from}/`)) throw new AssetError(from, t('cannot be put into itself: choose another folder.'));
  const next = (name: string): string => path + name.slice(from.length);
  const label = t('Renamed {name} to {next}', { name: from, next: path });
  const made = assets.folders.filter((folder) => folder === from || folder.startsWith(`${from}/`));
  return new Sequence(label, [
    () =>
      renameAll(scene, label, new Map(assetsBelow(scene, from).map((name) => [name, next(placedName(scene, name))]))),
    ...made.flatMap((folder) => [
      () => setFolder(label, assets, next(folder), true),
      () => setFolder(label, assets, folder, false),
    ]),
  ]);
}

/** Removes an empty folder and its subfolders. @throws AssetError when something is in it */
export function removeFolder(scene: Scene, path: string): Command {
  const { assets } = scene;
  const count = assetsBelow(scene, path).length;
  if (count > 0) {
    throw new AssetError(
      path,
      tCount(count, 'holds an asset: move or delete it first.', 'holds {count} assets: move or delete them first.'),
    );
  }
  const label = t('Deleted folder {name}', { name: path });
  const made = assets.folders.filter((folder) => folder === path || folder.startsWith(`${path}/`));
  return new Sequence(
    label,
    made.map((folder) => () => setFolder(label, assets, folder, false)),
  );
}

/** Edits that give objects a material, in place of a surface of their own. */
export const materialEdits = (renderers: readonly ObjectRenderer[], material: string): FieldEdit[] =>
  renderers.flatMap((owner): FieldEdit[] => [
    { owner, name: 'shader', value: null },
    { owner, name: 'material', value: material },
  ]);

export const giveMaterial = (renderers: readonly ObjectRenderer[], name: string, label: string): Command =>
  new SetFields(label, materialEdits(renderers, name));
