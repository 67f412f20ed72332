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
    const clean = takeClean();
    const look = async (): Promise<RecoveryOffer | null> => {
      for (const { id, isDirty } of await autosave.store.lost()) {
        if (!isDirty || clean.has(id)) await autosave.store.delete(id);
      }
      return autosave.findLost();
    };
    const found = await look();
    offer(found);
    // a tab that was closed just now may hold its lock a little longer
    if (!found)
      void opened.then(look).then(
        (late) => late && offer(late),
        (error: unknown) => autosave.refused(error),
      );
  } catch (error) {
    autosave.refused(error);
    offer(null);
  }
  return autosave;
}
