import type { Action } from '../api/Action';

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
