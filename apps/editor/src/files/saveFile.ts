import { t } from '@farol/editing';
import { fileSave, type FirstFileSaveOptions } from 'browser-fs-access';
import { browserReason } from './browserReason';

// exported again here, so that one import fetches these and `saveFile` as one bundle
export { mayReplace } from './mayReplace';
export { seenFile } from './seenFile';

export interface SaveRequest extends FirstFileSaveOptions {
  /** Name proposed by the picker, or used for a download. */
  readonly fileName: string;
}

/** Error saying why a file was not written, with a remedy. */
export function notSaved(fileName: string, error: unknown): Error {
  const { why, mend } = browserReason(error);
  return new Error(t('“{fileName}” was not saved: {why}. {mend}', { fileName, why, mend }), { cause: error });
}

/**
 * Writes a file to a place that the user chooses, or to an open file; downloads it in browsers without a file picker.
 * @param handle - the file to write to; null asks for one, as does a file that is gone
 * @returns the handle, for the next save; null after a download
 * @throws DOMException (AbortError) when the user cancelled the picker; else Error with name, reason and remedy
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
