import { Signal, t } from '@farol/editing';
import { AssetLibrary, Scene } from '@farol/engine';
import { createId, deserialize, readSceneFile } from '@farol/engine/files';
import { instantiatePrefab } from '@farol/engine/prefabs';
import type { EditorApi } from '../../api/EditorApi';
import { splitName } from '../../model/assetNames';
import { assetsOfClip, type CopiedObjects, copyObjects, isAssetThere, pasteObjects } from '../../model/clip';
import { land } from '../../viewport/placing/land';
import { assetEntry } from '../assetKinds';
import { keyedStore } from '../keyedStore';
import { landingView, pointInPicture } from '../landInPicture';
import type { DropPlace } from '../placeAsset';
import { readClipAssets } from '../readClipAssets';
import { thumbnailsOf } from '../thumbnails';
import { placeInstance } from './placeInstance';

/** A prefab of the user's library, or of an opened folder. */
export interface OwnItem {
  readonly id: string;
  readonly name: string;
  /** Words that a search matches: the folders in the prefab's name, or the name of its file. */
  readonly tags: readonly string[];
  readonly picture: Blob | null;
  /** Id that the prefab has in scenes. */
  readonly prefab: string;
}

/** An item stored in the browser: its objects as copied text, with the files that the text refers to. */
interface KeptItem extends OwnItem {
  readonly text: string;
  readonly files: ReadonlyMap<string, Blob>;
}

/** An item of a folder, whose scene file is read when the item is placed. */
interface FolderItem extends OwnItem {
  readonly file: File;
}

const store = keyedStore<KeptItem>('farol-library');

/** Emits when an item is stored or removed, and when a folder is opened. */
export const libraryChanged = new Signal();

/** Items of the folder opened last; forgotten when the page is closed. */
let folderItems: readonly FolderItem[] = [];

/** Items that the user has stored, by name; none when the browser has no storage. */
export async function keptItems(): Promise<readonly OwnItem[]> {
  const items = await store.all().catch(() => []);
  return items.toSorted((a, b) => a.name.localeCompare(b.name));
}

export const itemsOfFolder = (): readonly OwnItem[] => folderItems;

/** Picture of a prefab as the Assets panel shows it; null where none can be drawn. */
async function pictureOf(editor: EditorApi, prefab: string): Promise<Blob | null> {
  const entry = assetEntry(editor.document.scene, prefab);
  const address = entry && (await thumbnailsOf(editor).pictureOf(entry));
  if (!address) return null;
  const image = new Image();
  image.src = address;
  await image.decode();
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [image.naturalWidth, image.naturalHeight];
  canvas.getContext('2d')?.drawImage(image, 0, 0);
  return new Promise((resolve) => canvas.toBlob(resolve, 'image/webp'));
}

/** Copy of a prefab's instance, with all that it uses. @throws Error when the scene has no such prefab */
function copyPrefab(scene: Scene, id: string): CopiedObjects {
  const prefab = scene.prefabs.get(id);
  if (!prefab) throw new Error(t('This prefab is not in the scene any more.'));
  // copyObjects needs objects of a scene: a temporary scene that shares the user's assets holds the instance
  const { assets, registry } = scene;
  const beside = new Scene({ assets, registry });
  for (const each of scene.prefabs.list) beside.prefabs.set(each);
  const instance = instantiatePrefab(prefab, registry);
  beside.add(instance);
  try {
    return copyObjects(beside, [instance]);
  } finally {
    beside.dispose();
  }
}

/** Stores a prefab of the scene in the user's library, replacing one with the same id. @param prefab - its id */
export async function keepInLibrary(editor: EditorApi, prefab: string): Promise<void> {
  const { scene } = editor.document;
  const copied = copyPrefab(scene, prefab);
  const { folder, leaf } = splitName(scene.prefabs.get(prefab)!.name);
  const picture = await pictureOf(editor, prefab);
  const tags = folder === '' ? [] : folder.split('/');
  await store.put({ id: `own/${prefab}`, name: leaf, tags, picture, prefab, ...copied });
  libraryChanged.emit();
  editor.notices.show('info', t('{name} is in the library now, for all scenes.', { name: leaf }));
}

export async function removeFromLibrary(id: string): Promise<void> {
  await store.delete(id);
  libraryChanged.emit();
}

/**
 * Reads the prefabs of the scene files among files; an image file that is named like a prefab becomes its picture.
 * @throws Error when there are no prefabs
 */
export async function openLibraryFolder(editor: EditorApi, files: readonly File[]): Promise<void> {
  const pictures = new Map(
    files
      .filter(({ name }) => /\.(png|jpe?g|webp)$/i.test(name))
      .map((file) => [file.name.replace(/\.\w+$/, ''), file]),
  );
  const found: FolderItem[] = [];
  for (const file of files.filter(({ name }) => /\.(farol|json)$/i.test(name))) {
    const { text } = await readSceneFile(new Uint8Array(await file.arrayBuffer()), editor.mayUnpack);
    for (const { id, name } of prefabsIn(text)) {
      const { leaf } = splitName(name);
      const tags = [file.name.replace(/\.\w+$/, '')];
      found.push({
        id: `folder/${createId()}`,
        name: leaf,
        tags,
        picture: pictures.get(leaf) ?? null,
        prefab: id,
        file,
      });
    }
  }
  if (found.length === 0) throw new Error(t('No scene file of this folder has a prefab.'));
  folderItems = found.toSorted((a, b) => a.name.localeCompare(b.name));
  libraryChanged.emit();
}

/** Ids and names of the prefabs in a scene file's text; none when the text is not a scene. */
function prefabsIn(text: string): { readonly id: string; readonly name: string }[] {
  try {
    const { prefabs } = JSON.parse(text) as { prefabs?: { id: string; name: string }[] };
    return (prefabs ?? []).filter((each) => typeof each?.id === 'string' && typeof each.name === 'string');
  } catch {
    return [];
  }
}

/** Copy of a prefab in a scene file. */
async function copyFromFile(editor: EditorApi, { file, prefab }: FolderItem): Promise<CopiedObjects> {
  const { text, fileOf } = await readSceneFile(new Uint8Array(await file.arrayBuffer()), editor.mayUnpack);
  const registry = editor.document.scripts.withoutScripts(editor.components);
  const scene = await deserialize(text, { assets: new AssetLibrary(), registry, fileOf });
  try {
    return copyPrefab(scene, prefab);
  } finally {
    scene.dispose();
  }
}

async function copyOf(editor: EditorApi, id: string): Promise<{ prefab: string; copied: CopiedObjects }> {
  const inFolder = folderItems.find((each) => each.id === id);
  if (inFolder) return { prefab: inFolder.prefab, copied: await copyFromFile(editor, inFolder) };
  const kept = (await store.all()).find((each) => each.id === id);
  if (!kept) throw new Error(t('The library no longer has this item: choose another one.'));
  return { prefab: kept.prefab, copied: kept };
}

/** Places an instance of a prefab of the user's library or folder, as one undo step; see `placeLibraryItem`. */
export async function placeOwnItem(editor: EditorApi, id: string, place: DropPlace = {}): Promise<void> {
  const { document, commands } = editor;
  const { scene, selection } = document;
  const { prefab, copied } = await copyOf(editor, id);
  const known = scene.prefabs.get(prefab);
  if (known) return placeInstance(editor, known, place, { bring: () => ({ prefab: known, steps: [] }) });
  const { text, files } = copied;
  const assets = assetsOfClip(text);
  const isThere = assets.every((each) => isAssetThere(scene, each));
  const fileOf = async (name: string): Promise<Blob | null> => files.get(name) ?? null;
  const read = isThere ? undefined : await readClipAssets(editor, assets, fileOf);
  if (scene !== document.scene) return;
  const parent = place.parent ?? scene;
  const point = parent === scene ? pointInPicture(editor, place.at) : null;
  const put = pasteObjects(scene, text, parent, selection.ids, {
    read,
    label: (names) => t('Added {name}', { name: names }),
    place: (copies) => point && land(landingView(editor), copies, point),
  });
  commands.run(put);
}
