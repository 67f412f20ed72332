import type { AssetLibrary } from '@farol/engine';

/** The folder of an asset, '' for none, and its name without it. */
export function splitName(name: string): { folder: string; leaf: string } {
  const at = name.lastIndexOf('/');
  return { folder: name.slice(0, Math.max(at, 0)), leaf: name.slice(at + 1) };
}

export const joinName = (folder: string, leaf: string): string => (folder === '' ? leaf : `${folder}/${leaf}`);

/** Ending of a name that tells the format of its file, '.glb', '.ply.gz'; '' for what has none. */
export const endingOf = (name: string): string => /\.(?:ply\.gz|[a-z0-9]{2,5})$/i.exec(name)?.[0] ?? '';

/** A name that is free: 'Brick 2' when there is a 'Brick', 'robot 2.glb' when there is a 'robot.glb'. */
export const freeAssetName = (assets: AssetLibrary, name: string): string =>
  freeNameAmong((wanted) => assets.has(wanted), name);

/** As `freeAssetName`, where other names are taken. */
export function freeNameAmong(isTaken: (name: string) => boolean, name: string): string {
  for (const free of numberedNames(name)) if (!isTaken(free)) return free;
  return name;
}

/** A name, then those with numbers, without end: 'robot.glb', 'robot 2.glb', 'robot 3.glb'. */
export function* numberedNames(name: string): Generator<string, void> {
  yield name;
  const { folder, leaf } = splitName(name);
  const ending = endingOf(leaf);
  const stem = leaf.slice(0, leaf.length - ending.length);
  const [, root, number] = /^(.*?)(?: (\d+))?$/.exec(stem)!;
  for (let n = Number(number ?? 1) + 1; ; n++) yield joinName(folder, `${root} ${n}${ending}`);
}

/** Whether an asset can get another name or folder. */
export const canRename = (assets: AssetLibrary, name: string): boolean =>
  assets.has(name) &&
  !assets.isBuiltin(name) &&
  assets.modelOf(name) === null &&
  (assets.fileOf(name) !== null || assets.fieldAsset(name) !== null);
