import { t } from '@farol/editing';
import type { EditorApi } from '../../api/EditorApi';
import type { RecentFile } from '../../model/RecentFiles';
import { deleteRecent } from './recentStore';

/** Non-standard method of Chromium's file handles. */
interface Permitted {
  requestPermission?(options: { mode: 'read' }): Promise<PermissionState>;
}

/** The file's bytes. @throws Error saying why they cannot be read, with a remedy */
async function bytesOf({ name, handle, copy }: RecentFile): Promise<Blob> {
  if (!handle && copy) return copy;
  const mend = t('choose it by Open… in the menu File.');
  if (!handle) throw new Error(t('{name} was too large for a copy: {mend}', { name, mend }));
  const answer = (await (handle as Permitted).requestPermission?.({ mode: 'read' })) ?? 'granted';
  if (answer !== 'granted') throw new Error(t('The browser has no permission to read {name}: {mend}', { name, mend }));
  return handle.getFile().catch(() => {
    throw new Error(t('{name} is no longer where it was: {mend}', { name, mend }));
  });
}

/** Opens a recent file again; an unreadable one is removed from the list. @returns whether it was opened */
export async function openRecent(editor: EditorApi, file: RecentFile): Promise<boolean> {
  let bytes: Blob;
  try {
    bytes = await bytesOf(file);
  } catch (error) {
    if (!file.handle) await forgetRecent(editor, file);
    throw error;
  }
  return editor.openFileBytes(new Uint8Array(await bytes.arrayBuffer()), { name: file.name, handle: file.handle });
}

export async function forgetRecent({ recentFiles }: EditorApi, { id }: RecentFile): Promise<void> {
  await deleteRecent(id);
  recentFiles.list = recentFiles.list.filter((each) => each.id !== id);
}
