import { t } from '@farol/editing';
import type { EditorApi } from '../api/EditorApi';
import type { RecoveryOffer } from '../model/Dialogs';

/** How long the welcome waits for the browser's store (ms). */
const PATIENCE = 1500;

/**
 * Shows, before the first click, the welcome if it is wanted, and what can be recovered; whoever has begun to work is told
 * of it without a dialog.
 * @returns to be called once it is known what can be recovered; null for nothing
 */
export function welcomeUser(editor: EditorApi, isWanted: boolean): (recovery: RecoveryOffer | null) => void {
  const { dialogs, notices } = editor;
  let hasActed = false;
  const act = (): void => {
    hasActed = true;
  };
  for (const type of ['pointerdown', 'keydown', 'drop'])
    window.addEventListener(type, act, { capture: true, once: true });
  const show = (recovery: RecoveryOffer | null): void => {
    clearTimeout(timer);
    const isBusy = hasActed || (dialogs.current !== null && dialogs.current.kind !== 'welcome');
    if (isBusy) {
      if (recovery) notices.show('info', t('Unsaved work was found: “Recover…” in the menu File brings it back.'));
    } else if (isWanted) {
      if (recovery || dialogs.current === null) void dialogs.show({ kind: 'welcome', recovery });
    } else if (recovery) void dialogs.show({ kind: 'recover', ...recovery });
  };
  const timer = setTimeout(() => isWanted && show(null), PATIENCE);
  return show;
}
