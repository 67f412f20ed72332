import { t } from '@farol/editing';
import type { Action } from '../api/Action';

/** Adds a script to the library, and shows it. */
export const newScript: Action = {
  id: 'script.new',
  label: 'New script',
  icon: 'code',
  menu: { menu: 'object', group: 'material' },
  async run(editor) {
    const { addScript } = await import('../model/scriptEdits');
    const { command, name } = addScript(editor.document.scene, t('Script'));
    editor.commands.run(command);
    editor.openScript(name);
  },
};
