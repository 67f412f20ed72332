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

/** Escape: cancels a drag of the gizmo, else ends the open tool, else clears the selection. */
export const deselect: Action = {
  id: 'edit.deselect',
  label: 'Deselect',
  keys: ['Escape'],
  menu: { menu: 'edit', group: 'select' },
  run({ document, viewport, tools }) {
    if (!viewport.gizmo.cancel() && !tools.end()) document.selection.clear();
  },
};
