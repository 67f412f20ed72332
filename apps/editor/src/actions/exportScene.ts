import type { Action } from '../api/Action';

/** Shows the ways to give the scene away. */
export const exportScene: Action = {
  id: 'file.export',
  label: 'Export and share…',
  keys: ['Ctrl+Shift+E'],
  inFields: true,
  icon: 'assets',
  menu: { menu: 'file', group: 'share' },
  run: ({ dialogs }) => void dialogs.show({ kind: 'export' }),
};
