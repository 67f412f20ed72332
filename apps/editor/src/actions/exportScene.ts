import type { Action } from '../api/Action';

/** Opens the export dialog. */
export const exportScene: Action = {
  id: 'file.export',
  label: 'Export and share…',
  keys: ['Ctrl+Shift+E'],
  inFields: true,
  icon: 'assets',
  menu: { menu: 'file', group: 'share' },
  run: ({ dialogs }) => void dialogs.show({ kind: 'export' }),
};
