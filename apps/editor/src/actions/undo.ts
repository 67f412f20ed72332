import { t } from '@farol/editing';
import type { Action } from '../api/Action';

export const undo: Action = {
  id: 'edit.undo',
  label: ({ commands }) => (commands.undoLabel ? t('Undo: {edit}', { edit: commands.undoLabel }) : t('Undo')),
  keys: ['Ctrl+Z'],
  inFields: true,
  icon: 'undo',
  menu: { menu: 'edit', group: 'history' },
  run: ({ commands }) => commands.undo(),
  enabled: ({ commands }) => commands.undoLabel !== null || commands.isGestureOpen,
};
