import { t } from '@farol/editing';
import type { EditorApi } from '../api/EditorApi';
import type { RecoveryOffer } from '../model/Dialogs';

/** Longest wait for the browser's storage before the welcome page is shown (ms). */
const PATIENCE = 1500;

/**
 * Shows the welcome page if wanted, with sessions to recover. A user who has begun to work gets a notice instead of a
 * dialog.
 * @param load - fetches the code of the welcome page, which is shown once complete
 * @returns a function to call with the recoverable sessions; null for none
 */
export function welcomeUser(
  editor: EditorApi,
  isWanted: boolean,
  load: () => Promise<unknown>,
): (recovery: RecoveryOffer | null) => Promise<void> {
  const { dialogs, notices } = editor;
  let hasActed = false;
  const act = (): void => {
    hasActed = true;
  };
  for (const type of ['pointerdown', 'keydown', 'drop'])
    window.addEventListener(type, act, { capture: true, once: true });
  const show = async (recovery: RecoveryOffer | null): Promise<void> => {
    clearTimeout(timer);
    // the dialog reports code that cannot be fetched
    if (isWanted) await load().catch(() => {});
    const isBusy = hasActed || (dialogs.current !== null && dialogs.current.kind !== 'welcome');
    if (isBusy) {
      if (recovery) notices.show('info', t('Unsaved work was found: “Recover…” in the menu File brings it back.'));
    } else if (isWanted) {
      if (recovery || dialogs.current === null) void dialogs.show({ kind: 'welcome', recovery });
    } else if (recovery) void dialogs.show({ kind: 'recover', ...recovery });
  };
  const timer = setTimeout(() => isWanted && void show(null), PATIENCE);
  return show;
}
