import type { EditorApi } from '../../api/EditorApi';
import type { RecoveryOffer } from '../../model/Dialogs';
import { Autosave } from './Autosave';
import { AutosaveStore } from './AutosaveStore';
import { takeClean } from './cleanSessions';
import { missingForDrafts } from './draftReason';

/**
 * Begins to store changes, and looks for what tabs that were killed have left.
 * @param opened - fulfilled when the first scene and the plugins are there: what is recovered comes after them
 * @param offer - gets what was found; null for nothing
 * @returns null without IndexedDB or locks, as in some private windows: the user is told so
 */
export async function startAutosave(
  editor: EditorApi,
  opened: Promise<unknown>,
  offer: (recovery: RecoveryOffer | null) => void,
): Promise<Autosave | null> {
  const missing = missingForDrafts();
  if (missing !== null) {
    editor.drafts.fail(missing);
    editor.notices.show('warning', editor.drafts.problem!);
    offer(null);
    return null;
  }
  const autosave = new Autosave(editor, new AutosaveStore(), opened);
  try {
    const lost = await autosave.store.lost();
    const clean = takeClean();
    for (const { id, isDirty } of lost) if (!isDirty || clean.has(id)) await autosave.store.delete(id);
    offer(await autosave.findLost());
  } catch (error) {
    autosave.refused(error);
    offer(null);
  }
  return autosave;
}
