import { t } from '@farol/editing';
import type { Action } from '../api/Action';

/** Offers unsaved scenes of closed tabs again, including those put off by Later. */
export const recover: Action = {
  id: 'file.recover',
  label: 'Recover…',
  icon: 'undo',
  menu: { menu: 'file', group: 'recover' },
  async run(editor) {
    if (!editor.autosave) return;
    if (await editor.autosave.offerRecovery()) return;
    editor.notices.show('info', t('There is nothing to recover: no tab was closed with unsaved work'));
  },
  enabled: ({ autosave }) => autosave !== null,
};
