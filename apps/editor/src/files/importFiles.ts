import { shortText, t } from '@farol/editing';
import { AssetError } from '@farol/engine';
import {
  decodedUri,
  expandZips,
  packFbx,
  packGltf,
  packIES,
  packObj,
  readableEndings,
  typeOfUrl,
} from '@farol/engine/files';
import type { EditorApi } from '../api/EditorApi';
import { KnownFiles } from './knownAs';
import { firstNames } from './firstNames';
import { withProgress } from './withProgress';
import { numberedNames } from '../model/assetNames';
import { AddAssets } from '../model/commands/AddAssets';
import type { FileMap } from '@farol/engine/files';

/** Extensions of importable files, for messages. OBJ and STL are converted to GLB; ZIP files are unpacked. */
const importable = readableEndings.replace('.gltf,', '.gltf, .fbx, .obj, .stl, .zip,');

/** Whether a file can be imported by itself, judging by its extension. */
export const isImportable = (path: string): boolean => typeOfUrl(path) !== null || /\.(fbx|obj|stl|zip)$/i.test(path);

/** Maximum number of files that a message names. */
const LISTED = 8;

const nameIn = (path: string): string => path.slice(path.lastIndexOf('/') + 1);

/** A path, shortened for messages. */
const shortPath = (path: string): string => shortText(path, 80);

function find(files: FileMap, model: string, uri: string): [string, File] | null {
  const parts = model.split('/').slice(0, -1);
  for (const part of decodedUri(uri).replaceAll('\\', '/').split('/')) {
    if (part === '..') parts.pop();
    else if (part !== '.' && part !== '') parts.push(part);
  }
  const path = parts.join('/');
  // files that were chosen individually have no folder in their paths
  const found = [path, nameIn(path)].find((each) => files.has(each));
  return found === undefined ? null : [found, files.get(found)!];
}

/**
 * Packs a .gltf and the files that it names into one GLB. @param left - paths of unused files; used ones are removed
 */
async function packed(files: FileMap, path: string, left: Set<string>): Promise<Blob> {
  const bytes = await packGltf(await files.get(path)!.arrayBuffer(), async (uri) => {
    const found = find(files, path, uri);
    if (!found) return null;
    left.delete(found[0]);
    return found[1].arrayBuffer();
  });
  return new Blob([bytes], { type: 'model/gltf-binary' });
}

/**
 * A photometric file, with the tilt table of its lamp, which may be a separate file. @param left - paths of unused
 * files; used ones are removed
 */
async function packedProfile(files: FileMap, path: string, left: Set<string>): Promise<Blob> {
  const file = files.get(path)!;
  const bytes = await file.arrayBuffer();
  const packed = await packIES(bytes, async (name) => {
    const found = find(files, path, name) ?? findAnyCase(files, path, name);
    if (!found) return null;
    left.delete(found[0]);
    return found[1].arrayBuffer();
  });
  return packed === bytes ? file : new Blob([packed]);
}

/**
 * Finds a file ignoring case, as names from DOS need, in the folder of another file or among individually chosen ones.
 */
function findAnyCase(files: FileMap, path: string, name: string): [string, File] | null {
  const lowerCaseName = nameIn(name.replaceAll('\\', '/')).toLowerCase();
  const folder = path.slice(0, path.lastIndexOf('/') + 1);
  const found = [...files].filter(([each]) => each !== path && nameIn(each).toLowerCase() === lowerCaseName);
  return found.find(([each]) => each.startsWith(folder)) ?? found[0] ?? null;
}

/**
 * Packs an FBX, OBJ or STL with its materials and textures into one GLB. @param left - paths of unused files; used ones
 * are removed @param notes - receives what is missing
 */
async function packedObj(
  files: FileMap,
  path: string,
  left: Set<string>,
  notes: string[],
  signal: AbortSignal,
): Promise<Blob> {
  const pack = /\.fbx$/i.test(path) ? packFbx : packObj;
  const obj = await pack(files, path, signal);
  for (const each of obj.used) left.delete(each);
  notes.push(...obj.notes);
  return new Blob([obj.glb], { type: 'model/gltf-binary' });
}

export interface ImportResult {
  /** Names of all imported assets, including those that existed already. */
  readonly names: readonly string[];
  /** Names of the imported assets that existed already. */
  readonly known: readonly string[];
}

/**
 * Imports files as assets, in one step of history. All are read before anything changes; unreadable ones are reported
 * by name, and the rest is imported. Assets with identical bytes are reused.
 * @throws Error naming the files, when none of them can be imported; AbortError when the user cancelled, and then
 *   nothing has changed
 */
export function importFiles(editor: EditorApi, files: FileMap): Promise<ImportResult> {
  const [first = ''] = files.keys();
  const title =
    files.size === 1
      ? t('Reading {name}', { name: shortPath(nameIn(first)) })
      : t('Reading {count} files', { count: files.size });
  const problems: string[] = [];
  return withProgress(editor.dialogs, title, async (signal) => {
    const all = await expandZips(files, editor.mayUnpack, (problem) => problems.push(problem));
    if (all.size + problems.length === 0) throw new Error(t('There is nothing to import: the folder or ZIP is empty.'));
    return importAll(editor, all, problems, signal);
  });
}

/** Imports files without placing them, and reports those that existed already, since nothing would seem to happen. */
export async function importOnly(editor: EditorApi, files: FileMap): Promise<void> {
  const { known } = await importFiles(editor, files);
  if (known.length === 0) return;
  const names = firstNames([...new Set(known)], LISTED);
  editor.notices.show('info', t('These exist already, with the same content: {names}.', { names }));
}

async function importAll(
  editor: EditorApi,
  files: FileMap,
  problems: string[],
  signal: AbortSignal,
): Promise<ImportResult> {
  const { assets } = editor.document;
  const left = new Set(files.keys());
  const notes: string[] = [];
  const names: string[] = [];
  const added: string[] = [];
  const knownOnes: string[] = [];
  const existingFiles = new KnownFiles(assets);
  /** Generator of numbered names for each file name. */
  const numbered = new Map<string, Generator<string, void>>();
  const freeName = (fileName: string): string => {
    const next = numbered.get(fileName) ?? numberedNames(fileName);
    numbered.set(fileName, next);
    for (;;) {
      const name = next.next().value as string;
      if (!assets.has(name)) return name;
    }
  };
  const take = async (path: string, blob: Blob, fileName: string): Promise<void> => {
    const known = await existingFiles.find(blob);
    if (known) {
      names.push(known);
      knownOnes.push(known);
      return;
    }
    const name = freeName(fileName);
    assets.registerFile(name, blob);
    editor.document.toldElsewhere.add(name);
    try {
      await assets.load(name, signal);
      if (assets.typeOf(name) === 'sound') await assets.sound(name).decode();
      added.push(name);
      names.push(name);
      existingFiles.add({ name, type: assets.typeOf(name)!, blob });
    } catch (error) {
      assets.unregister(name);
      numbered.delete(fileName);
      signal.throwIfAborted();
      const { cause } = error as Error;
      problems.push(
        t('{path} cannot be imported: {reason}', {
          path: shortPath(path),
          reason: error instanceof AssetError && cause instanceof Error ? cause.message : (error as Error).message,
        }),
      );
    } finally {
      editor.document.toldElsewhere.delete(name);
    }
  };
  const takeAll = async (): Promise<void> => {
    // models first: files that they refer to become part of them
    for (const path of files.keys()) {
      const ending = /\.(gltf|fbx|obj|stl)$/i.exec(path)?.[1].toLowerCase();
      if (ending === undefined) continue;
      left.delete(path);
      try {
        const blob = await (ending !== 'gltf'
          ? packedObj(files, path, left, notes, signal)
          : packed(files, path, left));
        await take(path, blob, nameIn(path).replace(/\.\w+$/, '.glb'));
      } catch (error) {
        signal.throwIfAborted();
        problems.push(
          t('{path} cannot be imported: {reason}', {
            path: shortPath(path),
            reason: error instanceof Error ? error.message : String(error),
          }),
        );
      }
    }
    for (const path of [...left].filter((each) => typeOfUrl(each) === 'profile')) {
      left.delete(path);
      await take(path, await packedProfile(files, path, left), nameIn(path));
    }
    for (const path of left) if (typeOfUrl(path)) await take(path, files.get(path)!, nameIn(path));
  };
  try {
    await takeAll();
  } catch (error) {
    // when cancelled, the assets added so far are removed
    for (const name of added) {
      const asset = assets.get(name);
      assets.unregister(name);
      asset.dispose();
    }
    throw error;
  }
  const unknown = [...left].filter((path) => !typeOfUrl(path));
  if (assets === editor.document.assets) {
    editor.commands.run(
      new AddAssets(
        assets,
        added.map((name) => assets.take(name)),
      ),
    );
  }
  const scene = unknown.find((path) => /\.farol$/i.test(path));
  if (scene !== undefined) {
    problems.push(
      t('{path} is a scene within a ZIP: unpack the ZIP, and open it by itself.', { path: shortPath(scene) }),
    );
  }
  if (unknown.length > 0 && names.length + problems.length === 0) {
    throw new Error(
      t('{names} cannot be imported: only {importable} can.', {
        names: firstNames(unknown, LISTED),
        importable,
      }),
    );
  }
  // unrelated files in folders, such as licences, are ignored silently
  const leftOut = unknown.filter((path) => path !== scene && !path.includes('/'));
  if (leftOut.length > 0)
    notes.push(
      t('{names} cannot be imported: only {importable} can.', {
        names: firstNames(leftOut, LISTED),
        importable,
      }),
    );
  for (const problem of problems) editor.notices.show('error', problem);
  if (notes.length > 0) editor.notices.show('warning', notes.join('\n'));
  return { names, known: knownOnes };
}
