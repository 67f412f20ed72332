import { shortText, t } from '@farol/editing';
import { AssetError, type AssetLibrary, type TakenAsset } from '@farol/engine';
import { type FileAsset, foreignAddresses } from '@farol/engine/files';
import type { EditorApi } from '../api/EditorApi';
import { freeNameAmong } from '../model/assetNames';
import { nameInScene, type ReadAsset } from '../model/bringAssets';
import { mayRunTexts } from '../scripts/knownScripts';
import { askForHosts } from './askForHosts';
import { KnownFiles } from './knownAs';
import { withProgress } from './withProgress';

/** Returns the file of a copied asset by its name; null when it no longer exists. */
type FileOf = (name: string) => Promise<Blob | null>;

/**
 * Reads assets of copied objects that the scene lacks: files of the clipboard, and URLs, after the user has allowed
 * their hosts. When there are scripts that the user never ran, all scripts of the scene are switched off until the user
 * decides. Unreadable assets are reported by name.
 * @param list - assets, each after those that it uses
 * @param fileOf - returns a file of the list by name; the clipboard's when absent
 * @throws AbortError when the user cancelled, and then nothing has changed
 */
export async function readClipAssets(
  editor: EditorApi,
  list: readonly FileAsset[],
  fileOf: FileOf = (name) => editor.clipboard.file(name),
): Promise<ReadonlyMap<string, ReadAsset>> {
  const { scene, assets, scripts } = editor.document;
  const missing = list.filter((each) => each.values === undefined && nameInScene(scene, each) === null);
  const refused = await askAbout(editor, missing);
  const read = await withProgress(editor.dialogs, t('Pasting'), (signal) =>
    readAll(editor, missing, refused, fileOf, signal),
  );
  const texts = list.flatMap(({ name, type, values }) => {
    const source = type === 'script' && typeof values?.source === 'string' ? values.source : null;
    return source === null || assets.fieldAsset(name)?.get('source') === source ? [] : source;
  });
  if (!(await mayRunTexts(texts)) && assets === editor.document.assets) scripts.ask();
  return read;
}

/** Asks about hosts. @returns URLs on hosts that the user refused */
async function askAbout(editor: EditorApi, wanted: readonly FileAsset[]): Promise<ReadonlySet<string>> {
  const { assets } = editor.document;
  const { allowedOrigins } = assets;
  const asked = foreignAddresses({ assets: [...wanted] }).filter(({ origin }) => allowedOrigins?.has(origin) === false);
  if (asked.length === 0) return new Set();
  if (!(await askForHosts(editor.dialogs, t('What was copied'), asked)))
    return new Set(asked.map(({ asset }) => asset));
  assets.allowedOrigins = new Set([...(allowedOrigins ?? []), ...asked.map(({ origin }) => origin)]);
  return new Set();
}

async function readAll(
  editor: EditorApi,
  wanted: readonly FileAsset[],
  refused: ReadonlySet<string>,
  fileOf: FileOf,
  signal: AbortSignal,
): Promise<ReadonlyMap<string, ReadAsset>> {
  const { assets } = editor.document;
  const read = new Map<string, ReadAsset>();
  const files = new KnownFiles(assets);
  try {
    for (const each of wanted) {
      read.set(each.name, null);
      if (!refused.has(each.name)) read.set(each.name, await readOne(editor, each, read, files, fileOf, signal));
    }
  } catch (error) {
    for (const each of read.values()) if (isTaken(each)) each.value?.dispose();
    throw error;
  }
  if (assets !== editor.document.assets) throw new DOMException('Another scene was opened.', 'AbortError');
  return read;
}

const isTaken = (read: ReadAsset): read is TakenAsset => read !== null && typeof read === 'object';

async function readOne(
  editor: EditorApi,
  asset: FileAsset,
  read: ReadonlyMap<string, ReadAsset>,
  files: KnownFiles,
  fileOf: FileOf,
  signal: AbortSignal,
): Promise<ReadAsset> {
  const { assets } = editor.document;
  const tell = (reason: string): null => {
    const text = t('{name} could not be pasted: {reason}', { name: shortText(asset.name, 80), reason });
    editor.notices.show('error', text);
    return null;
  };
  const blob = asset.file === undefined ? null : await fileOf(asset.file);
  if (asset.file !== undefined && blob === null)
    return tell(t('its file is no longer there. Copy it again, in a tab that has it open.'));
  const same = blob && (await files.find(blob, asset.type));
  if (same) return same;
  const others = new Set([...read.values()].filter(isTaken).map(({ name }) => name));
  const free = freeNameAmong((name) => assets.has(name) || others.has(name), asset.name);
  try {
    register(assets, free, asset, blob);
    await assets.load(free, signal);
    return assets.take(free);
  } catch (error) {
    assets.unregister(free);
    signal.throwIfAborted();
    const { cause } = error as Error;
    return tell(error instanceof AssetError && cause instanceof Error ? cause.message : (error as Error).message);
  }
}

function register(assets: AssetLibrary, name: string, { type, url }: FileAsset, blob: Blob | null): void {
  if (blob) assets.registerFile(name, blob, type);
  else assets.registerUrl(name, url!, type);
}
