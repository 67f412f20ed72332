import { t } from '@farol/editing';
import type { EditorApi } from '../api/EditorApi';
import { stampOf } from './seenFile';

/**
 * Asks before overwriting a file that another tab or program has changed since the document was read from it or saved
 * to it.
 * @returns the file, if it may be overwritten, or is gone; null to choose another one
 * @throws DOMException (AbortError) when the user cancelled
 */
export async function mayReplace(
  { dialogs, file }: EditorApi,
  handle: FileSystemFileHandle,
): Promise<FileSystemFileHandle | null> {
  for (let seen = file.seen; ;) {
    const stampOnDisk = await handle.getFile().then(stampOf, () => undefined);
    if (stampOnDisk === undefined || stampOnDisk === seen) return handle;
    let savesAs = false;
    const replaces = await dialogs.show({
      kind: 'confirm',
      title: t('“{name}” has changed', { name: handle.name }),
      text: t(
        'Another tab or program has written “{name}” since it was opened or saved here. To save over it loses what it holds now; under another name both are kept.',
        { name: handle.name },
      ),
      action: t('Save over it'),
      other: {
        label: t('Save as…'),
        choose: () => {
          savesAs = true;
        },
      },
    });
    if (savesAs) return null;
    if (!replaces) throw new DOMException('The user turned back.', 'AbortError');
    // the file may change again while the user is being asked
    seen = stampOnDisk;
  }
}
