import { duplicateObjects } from '../model/edits';
import type { Action } from '../api/Action';
import { hasSelection } from './hasSelection';

export const duplicate: Action = {
  id: 'edit.duplicate',
  label: 'Duplicate',
  keys: ['Ctrl+D'],
  icon: 'duplicate',
  menu: { menu: 'edit', group: 'clipboard' },
  run: ({ document, commands }) => commands.run(duplicateObjects(document.scene, document.selectedObjects)),
  enabled: hasSelection,
};
