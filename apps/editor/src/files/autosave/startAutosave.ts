import type { EditorApi } from '../../api/EditorApi';
import type { RecoveryOffer } from '../../model/Dialogs';
import { Autosave } from './Autosave';
import { AutosaveStore } from './AutosaveStore';
import { takeClean } from './cleanSessions';
import { missingForDrafts } from './draftReason';

/**
 * Starts storing changes, and looks for unsaved sessions of tabs that were killed.
 * @param opened - fulfilled when the first scene and the plugins are loaded; recovery waits for it
 * @param offer - called with the sessions found; null for none
 * @returns null without IndexedDB or locks, as in some private windows; the user is told
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
    // searches again, since a tab that was just closed may still hold its lock
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
