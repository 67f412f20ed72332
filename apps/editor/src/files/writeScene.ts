import { t } from '@farol/editing';
import type { Scene } from '@farol/engine';
import { containerContent, inlineAssets, writeContainer } from '@farol/engine/files';
import type { EditorApi } from '../api/EditorApi';
import { fileNameOf } from './fileNameOf';
import { fileType } from './fileType';
import { keepPicture } from './recent/scenePicture';
import { mayReplace, notSaved, saveFile, seenFile } from './saveFile';

/**
 * The scene as a file: JSON with assets inlined for a `.json` name, else a container.
 * @throws Error naming the file and the reason
 */
async function bytesFor(scene: Scene, name: string): Promise<Blob> {
  try {
    const content = containerContent(scene);
    const isJson = name.toLowerCase().endsWith('.json');
    const part = isJson ? `${JSON.stringify(await inlineAssets(content), null, 1)}\n` : await writeContainer(content);
    return new Blob([part], { type: isJson ? 'application/json' : fileType.mimeTypes[0] });
  } catch (error) {
    throw notSaved(name, error);
  }
}

/** Id of the notice of each editor's last failed save, removed by the next success. */
const failures = new WeakMap<EditorApi, number>();

/**
 * Saves the scene, and shows the result.
 * @param handle - the file to write to; null asks for one
 */
export async function writeScene(editor: EditorApi, handle: FileSystemFileHandle | null): Promise<void> {
  const { notices } = editor;
  try {
    const name = await writeTo(editor, handle && (await mayReplace(editor, handle)));
    notices.remove(failures.get(editor) ?? 0);
    notices.show('info', t('Saved {name}', { name }));
  } catch (error) {
    if (!(error instanceof Error) || error.name === 'AbortError') throw error;
    failures.set(editor, notices.show('error', error.message, 'file', { lasts: true }));
  }
}

/** Writes the scene to a file. @returns the file's name */
async function writeTo(editor: EditorApi, handle: FileSystemFileHandle | null): Promise<string> {
  const { scene } = editor.document;
  const fileName = handle?.name ?? editor.file.name ?? `${fileNameOf(scene.name)}.farol`;
  const step = editor.commands.last;
  await keepPicture(editor, fileName);
  // the picker returns a file handle; browsers without a picker download the file and return null
  let content = await bytesFor(scene, fileName);
  let saved = await saveFile(content, { ...fileType, fileName }, handle);
  if (saved && saved.name.endsWith('.json') !== fileName.endsWith('.json')) {
    // another extension was chosen in the picker: encodes the scene again
    content = await bytesFor(scene, saved.name);
    saved = await saveFile(content, { ...fileType, fileName: saved.name }, saved);
  }
  const name = saved?.name ?? fileName;
  // not marked as saved when another scene was opened meanwhile: that one would be saved to this file later
  if (editor.document.scene !== scene) return name;
  editor.saved(await seenFile(content, { name, handle: saved }), step);
  const { noteRecent } = await import('./recent/noteRecent');
  void noteRecent(editor, content, true);
  return name;
}
