import type { Action } from '../api/Action';

export const showPalette: Action = {
  id: 'help.palette',
  label: 'Search commands',
  keys: ['Ctrl+K'],
  inFields: true,
  icon: 'search',
  menu: { menu: 'help', group: 'keys' },
  run: ({ dialogs }) => void dialogs.show({ kind: 'palette' }),
};
