import type { Editor } from '../../Editor';
import { Autosave } from './Autosave';
import { AutosaveStore } from './AutosaveStore';
import { takeClean } from './cleanSessions';
import { missingForDrafts } from './draftReason';
import type { SessionInfo } from './store';

/** Puts a scene that was stored back, as one that is not saved. @returns whether it was opened */
export async function recover(editor: Editor, autosave: Autosave, session: SessionInfo): Promise<boolean> {
  if (!(await editor.mayLoseChanges())) return false;
  const { text, files } = await autosave.store.read(session.id);
  const file = { name: session.fileName, handle: session.handle };
  if (!(await editor.openFileBytes(text, file, (path) => files.get(path) ?? null))) return false;
  editor.commands.markUnsaved();
  autosave.replace(session.id);
  editor.notices.show('info', `${session.name} is as it was. Save it to keep it.`);
  return true;
}

/** Offers what tabs that were killed have left. @returns whether there was any */
export async function offerRecovery(editor: Editor, autosave: Autosave): Promise<boolean> {
  const lost = await autosave.store.lost();
  const sessions = lost.filter(({ isDirty }) => isDirty);
  if (sessions.length > 0) void editor.dialogs.show({ kind: 'recover', sessions, autosave });
  return sessions.length > 0;
}

/**
 * Begins to store changes, and offers what a tab that was killed has left.
 * @returns null without IndexedDB or locks, as in some private windows: the user is told so
 */
export async function startAutosave(editor: Editor): Promise<Autosave | null> {
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
    await offerRecovery(editor, autosave);
  } catch (error) {
    autosave.refused(error);
  }
  return autosave;
}
