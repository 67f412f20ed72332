import type { Action } from './Action';

/** Offers again what tabs that were closed without warning have left, and what was put off by Later. */
export const recover: Action = {
  id: 'file.recover',
  label: 'Recover…',
  icon: 'undo',
  async run(editor) {
    if (!editor.autosave) return;
    const { offerRecovery } = await import('../files/autosave/startAutosave');
    if (await offerRecovery(editor, editor.autosave)) return;
    editor.notices.show('info', 'There is nothing to recover: no tab was closed with unsaved work');
  },
  enabled: ({ autosave }) => autosave !== null,
};
