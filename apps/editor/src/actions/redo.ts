import type { Action } from '../api/Action';
import { t } from '@farol/editing';

export const redo: Action = {
  id: 'edit.redo',
  label: ({ commands }) => (commands.redoLabel ? t('Redo: {edit}', { edit: commands.redoLabel }) : t('Redo')),
  keys: ['Ctrl+Y', 'Ctrl+Shift+Z'],
  inFields: true,
  icon: 'redo',
  menu: { menu: 'edit', group: 'history' },
  run: ({ commands }) => commands.redo(),
  enabled: ({ commands }) => commands.redoLabel !== null,
};
