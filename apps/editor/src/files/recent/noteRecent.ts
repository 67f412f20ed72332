import { createId } from '@farol/engine/files';
import type { EditorApi, OpenFile } from '../../api/EditorApi';
import type { RecentFile } from '../../model/RecentFiles';
import { deleteRecent, readRecent, writeRecent } from './recentStore';
import { storedPicture } from './scenePicture';
import { smallPicture } from './smallPicture';

/** Number of files that are remembered. */
const MOST = 8;

/** Largest file kept as a copy when the browser provides no handle (bytes). */
const LARGEST_COPY = 32e6;

/** Delay after which the textures of an opened scene are mostly loaded (ms). */
const SETTLED = 2000;

/** Resolves when the page is idle. */
const idle = (): Promise<void> =>
  new Promise((resolve) => {
    if ('requestIdleCallback' in window) requestIdleCallback(() => resolve(), { timeout: SETTLED });
    else setTimeout(resolve, 300);
  });

async function isSame(known: RecentFile, { name, handle }: OpenFile): Promise<boolean> {
  if (known.handle && handle) return known.handle.isSameEntry(handle);
  return known.name === name && !known.handle && !handle;
}

/** Reads the stored list into `editor.recentFiles`; an empty list when the browser has no storage. */
export async function loadRecent({ recentFiles }: EditorApi): Promise<void> {
  recentFiles.list = await readRecent().catch(() => []);
}

async function write(editor: EditorApi, file: RecentFile): Promise<void> {
  await writeRecent(file);
  const others = (await readRecent()).filter(({ id }) => id !== file.id);
  for (const old of others.splice(MOST - 1)) await deleteRecent(old.id);
  editor.recentFiles.list = [file, ...others];
}

/**
 * Adds the open file to the recent ones, with its own picture, or else a thumbnail. Failures of storage are ignored.
 * @param content - the file's bytes
 * @param isDrawn - whether the viewport shows the complete scene; else the thumbnail is taken a little later
 */
export async function noteRecent(editor: EditorApi, content: Blob, isDrawn: boolean): Promise<void> {
  const { file, document } = editor;
  const { scene } = document;
  if (file.name === null) return;
  try {
    const isHandle = 'FileSystemFileHandle' in window && file.handle instanceof FileSystemFileHandle;
    const handle = isHandle ? file.handle : null;
    const known = editor.recentFiles.list;
    const same = await Promise.all(known.map((each) => isSame(each, { name: file.name, handle })));
    const old = known.find((_, i) => same[i]);
    const stored = storedPicture(scene);
    if (isDrawn) await idle();
    const noted: RecentFile = {
      id: old?.id ?? createId(),
      name: file.name,
      scene: scene.name,
      time: Date.now(),
      handle,
      copy: handle || content.size > LARGEST_COPY ? null : content,
      picture: stored ?? (isDrawn ? await smallPicture(editor) : old?.picture) ?? null,
    };
    await write(editor, noted);
    if (isDrawn || stored) return;
    await new Promise((resolve) => setTimeout(resolve, SETTLED));
    if (document.scene === scene) await write(editor, { ...noted, picture: await smallPicture(editor) });
  } catch (error) {
    editor.log.add('warning', 'file', `${file.name} is not among the recent files: ${String(error)}`);
  }
}
