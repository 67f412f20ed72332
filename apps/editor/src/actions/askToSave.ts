import { t } from '@farol/editing';
import { save } from './file';
import type { EditorApi } from '../api/EditorApi';

/**
 * Asks what to do with unsaved changes, before another scene replaces this one.
 * @returns whether it may be replaced: the changes are saved or given up
 */
export async function askToSave(editor: EditorApi): Promise<boolean> {
  let isDropped = false;
  const saves = await editor.dialogs.show({
    kind: 'confirm',
    title: t('Unsaved changes'),
    text: t('“{name}” has changes that are not saved. Save them before it is closed?', {
      name: editor.document.scene.name,
    }),
    action: t('Save'),
    other: {
      label: t('Don’t save'),
      choose: () => {
        isDropped = true;
      },
    },
  });
  if (!saves) return isDropped;
  try {
    await save.run(editor);
  } catch (error) {
    // a cancelled file picker rejects with AbortError: the scene stays open
    if (!(error instanceof Error) || error.name !== 'AbortError') throw error;
  }
  return !editor.commands.isDirty;
}
