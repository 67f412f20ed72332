import type { Action } from '../api/Action';

export const selectAll: Action = {
  id: 'edit.select-all',
  label: 'Select everything',
  keys: ['Ctrl+A'],
  menu: { menu: 'edit', group: 'select' },
  run({ document }) {
    const ids: string[] = [];
    document.scene.traverse((object) => {
      if (!object.lockedInHierarchy) ids.push(object.id);
    });
    document.selection.set(ids);
  },
};
