import type { EditorApi } from '../../api/EditorApi';
import { Autosave } from './Autosave';
import { AutosaveStore } from './AutosaveStore';
import { takeClean } from './cleanSessions';
import { missingForDrafts } from './draftReason';

/**
 * Begins to store changes, and offers what a tab that was killed has left.
 * @returns null without IndexedDB or locks, as in some private windows: the user is told so
 */
export async function startAutosave(editor: EditorApi): Promise<Autosave | null> {
  const missing = missingForDrafts();
  if (missing !== null) {
    editor.drafts.fail(missing);
    editor.notices.show('warning', editor.drafts.problem!);
    return null;
  }
  const autosave = new Autosave(editor, new AutosaveStore());
  try {
    const lost = await autosave.store.lost();
    const clean = takeClean();
    for (const { id, isDirty } of lost) if (!isDirty || clean.has(id)) await autosave.store.delete(id);
    await autosave.offerRecovery();
  } catch (error) {
    autosave.refused(error);
  }
  return autosave;
}
