import type { Action } from '../api/Action';

export const undo: Action = {
  id: 'edit.undo',
  label: ({ commands }) => (commands.undoLabel ? `Undo ${lower(commands.undoLabel)}` : 'Undo'),
  keys: ['Ctrl+Z'],
  inFields: true,
  icon: 'undo',
  run: ({ commands }) => commands.undo(),
  enabled: ({ commands }) => commands.undoLabel !== null || commands.isGestureOpen,
};

/** The label of a step within a sentence. */
export const lower = (label: string): string => label.charAt(0).toLowerCase() + label.slice(1);
