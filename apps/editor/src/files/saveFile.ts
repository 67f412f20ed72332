import { t } from '@farol/editing';
import { fileSave, type FirstFileSaveOptions } from 'browser-fs-access';
import { browserReason } from './browserReason';

// what a save needs is fetched together
export { mayReplace } from './mayReplace';
export { seenFile } from './seenFile';

export interface SaveRequest extends FirstFileSaveOptions {
  /** Name that the picker proposes, or that a download gets. */
  readonly fileName: string;
}

/** What is said of a file that was not written, and by whose fault. */
export function notSaved(fileName: string, error: unknown): Error {
  const { why, mend } = browserReason(error);
  return new Error(t('“{fileName}” was not saved: {why}. {mend}', { fileName, why, mend }), { cause: error });
}

/**
 * Writes a file where the user says, or to one that is open; a browser without a picker downloads.
 * @param handle - the file to write to; null asks for one, as does a file that is gone
 * @returns the file, for the next time; null after a download
 * @throws DOMException (AbortError) when the user turned back from choosing; else Error: the name, why, and what to do
 */
export async function saveFile(
  blob: Blob,
  request: SaveRequest,
  handle: FileSystemFileHandle | null = null,
): Promise<FileSystemFileHandle | null> {
  let target = handle && (await isThere(handle)) ? handle : null;
  try {
    const saved = await fileSave(
      blob,
      { ...request, mimeTypes: [...(request.mimeTypes ?? [])] },
      target,
      false,
      (picked) => {
        target = picked;
      },
    );
    return saved ?? null;
  } catch (error) {
    if (!target && error instanceof DOMException && error.name === 'AbortError') throw error;
    throw notSaved(target?.name ?? request.fileName, error);
  }
}

async function isThere(handle: FileSystemFileHandle): Promise<boolean> {
  try {
    await handle.getFile();
    return true;
  } catch {
    return false;
  }
}
