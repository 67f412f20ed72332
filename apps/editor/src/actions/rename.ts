import type { Action } from '../api/Action';

export const rename: Action = {
  id: 'edit.rename',
  label: 'Rename',
  keys: ['F2'],
  menu: { menu: 'object', group: 'name' },
  run: ({ renameRequested }) => renameRequested.emit(),
  enabled: ({ document }) => document.selection.ids.length === 1,
};
