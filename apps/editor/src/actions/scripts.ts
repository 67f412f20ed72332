import { t } from '@farol/editing';
import type { Action } from '../api/Action';

/** Adds a script to the library and its component to the selected objects, and opens the script. */
export const newScript: Action = {
  id: 'script.new',
  label: 'New script',
  icon: 'code',
  menu: { menu: 'object', group: 'material' },
  async run(editor) {
    const { newScript: make } = await import('../files/newScript');
    make(editor, t('Script'), editor.document.selectedObjects);
  },
};
