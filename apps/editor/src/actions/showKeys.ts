import type { Action } from '../api/Action';

export const showKeys: Action = {
  id: 'help.keys',
  label: 'Keys',
  keys: ['?'],
  icon: 'keyboard',
  menu: { menu: 'help', group: 'keys' },
  run: ({ dialogs }) => void dialogs.show({ kind: 'keys' }),
};
