import type { Action } from '../api/Action';
import { hasSelection } from './hasSelection';

export const group: Action = {
  id: 'edit.group',
  label: 'Group',
  keys: ['Ctrl+G'],
  icon: 'folder',
  menu: { menu: 'object', group: 'tree' },
  async run({ document, commands }) {
    const { groupObjects } = await import('../model/groupObjects');
    if (document.selectedObjects.length > 0) commands.run(groupObjects(document.scene, document.selectedObjects));
  },
  enabled: hasSelection,
};

export const ungroup: Action = {
  id: 'edit.ungroup',
  label: 'Ungroup',
  keys: ['Ctrl+Shift+G'],
  menu: { menu: 'object', group: 'tree' },
  async run({ document, commands }) {
    const { ungroupObjects } = await import('../model/groupObjects');
    if (document.selectedObjects.length > 0) commands.run(ungroupObjects(document.scene, document.selectedObjects));
  },
  enabled: ({ document }) => document.selectedObjects.some(({ children }) => children.length > 0),
};
