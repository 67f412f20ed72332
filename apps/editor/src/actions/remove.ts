import { deleteObjects } from '../model/edits';
import type { Action } from '../api/Action';
import { hasSelection } from './hasSelection';

export const remove: Action = {
  id: 'edit.delete',
  label: 'Delete',
  keys: ['Delete', 'Backspace'],
  icon: 'remove',
  menu: { menu: 'edit', group: 'clipboard' },
  run: ({ document, commands }) => commands.run(deleteObjects(document.scene, document.selectedObjects)),
  enabled: hasSelection,
};
