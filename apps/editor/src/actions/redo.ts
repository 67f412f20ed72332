import type { Action } from '../api/Action';
import { lower } from './undo';

export const redo: Action = {
  id: 'edit.redo',
  label: ({ commands }) => (commands.redoLabel ? `Redo ${lower(commands.redoLabel)}` : 'Redo'),
  keys: ['Ctrl+Y', 'Ctrl+Shift+Z'],
  inFields: true,
  icon: 'redo',
  run: ({ commands }) => commands.redo(),
  enabled: ({ commands }) => commands.redoLabel !== null,
};
