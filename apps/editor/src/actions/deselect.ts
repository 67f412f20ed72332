import type { Action } from '../api/Action';

/** Escape: ends a drag of the gizmo and puts everything back; else leaves the tool that is open; else selects nothing. */
export const deselect: Action = {
  id: 'edit.deselect',
  label: 'Deselect',
  keys: ['Escape'],
  menu: { menu: 'edit', group: 'select' },
  run({ document, viewport, tools }) {
    if (!viewport.gizmo.cancel() && !tools.end()) document.selection.clear();
  },
};
