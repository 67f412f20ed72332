import type { AssetLibrary } from '@farol/engine';

/** Splits an asset's name into its folder, '' for none, and the rest. */
export function splitName(name: string): { folder: string; leaf: string } {
  const at = name.lastIndexOf('/');
  return { folder: name.slice(0, Math.max(at, 0)), leaf: name.slice(at + 1) };
}

export const joinName = (folder: string, leaf: string): string => (folder === '' ? leaf : `${folder}/${leaf}`);

/** File extension of a name: '.glb', '.ply.gz'; '' when it has none. */
export const endingOf = (name: string): string => /\.(?:ply\.gz|[a-z0-9]{2,5})$/i.exec(name)?.[0] ?? '';

/** A free name: 'Brick 2' when there is a 'Brick', 'robot 2.glb' when there is a 'robot.glb'. */
export const freeAssetName = (assets: AssetLibrary, name: string): string =>
  freeNameAmong((wanted) => assets.has(wanted), name);

/** Like `freeAssetName`. @param isTaken - whether a name is in use */
export function freeNameAmong(isTaken: (name: string) => boolean, name: string): string {
  for (const free of numberedNames(name)) if (!isTaken(free)) return free;
  return name;
}

/** A name, then numbered ones without end: 'robot.glb', 'robot 2.glb', 'robot 3.glb'. */
export function* numberedNames(name: string): Generator<string, void> {
  yield name;
  const { folder, leaf } = splitName(name);
  const ending = endingOf(leaf);
  const stem = leaf.slice(0, leaf.length - ending.length);
  const [, root, number] = /^(.*?)(?: (\d+))?$/.exec(stem)!;
  for (let n = Number(number ?? 1) + 1; ; n++) yield joinName(folder, `${root} ${n}${ending}`);
}

/** Whether an asset can be renamed or moved to another folder. */
export const canRename = (assets: AssetLibrary, name: string): boolean =>
  assets.has(name) &&
  !assets.isBuiltin(name) &&
  assets.modelOf(name) === null &&
  (assets.fileOf(name) !== null || assets.fieldAsset(name) !== null);
