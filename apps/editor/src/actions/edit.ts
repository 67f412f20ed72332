import { t } from '@farol/editing';
import type { Action } from '../api/Action';
import { deleteObjects, duplicateObjects } from '../model/edits';
import { hasSelection } from './hasSelection';

export const undo: Action = {
  id: 'edit.undo',
  label: ({ commands }) => (commands.undoLabel ? t('Undo: {edit}', { edit: commands.undoLabel }) : t('Undo')),
  keys: ['Ctrl+Z'],
  inFields: true,
  icon: 'undo',
  run: ({ commands }) => commands.undo(),
  enabled: ({ commands }) => commands.undoLabel !== null || commands.isGestureOpen,
};

export const redo: Action = {
  id: 'edit.redo',
  label: ({ commands }) => (commands.redoLabel ? t('Redo: {edit}', { edit: commands.redoLabel }) : t('Redo')),
  keys: ['Ctrl+Y', 'Ctrl+Shift+Z'],
  inFields: true,
  icon: 'redo',
  run: ({ commands }) => commands.redo(),
  enabled: ({ commands }) => commands.redoLabel !== null,
};

export const duplicate: Action = {
  id: 'edit.duplicate',
  label: 'Duplicate',
  keys: ['Ctrl+D'],
  icon: 'duplicate',
  run: ({ document, commands }) => commands.run(duplicateObjects(document.scene, document.selectedObjects)),
  enabled: hasSelection,
};

export const remove: Action = {
  id: 'edit.delete',
  label: 'Delete',
  keys: ['Delete', 'Backspace'],
  icon: 'remove',
  run: ({ document, commands }) => commands.run(deleteObjects(document.scene, document.selectedObjects)),
  enabled: hasSelection,
};

export const selectAll: Action = {
  id: 'edit.select-all',
  label: 'Select everything',
  keys: ['Ctrl+A'],
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
  run({ document, viewport, tools }) {
    if (!viewport.gizmo.cancel() && !tools.end()) document.selection.clear();
  },
};
