import { t } from '@farol/editing';
import type { EditorApi } from '../api/EditorApi';
import { actionEntry, type MenuEntry } from '../api/MenuEntry';
import type { Action } from '../api/Action';
import { addEntries } from './addEntries';
import { copy, cut, paste, pasteBelow } from './clipboard';
import { duplicate, remove } from './edit';
import { duplicateMany, group, hide, lock, makePrefab, rename, ungroup, unpackPrefab } from './object';
import { focus } from './viewpoint';

/** Context menu of the selected objects; null when nothing is selected. */
export function objectEntries(editor: EditorApi): MenuEntry[] | null {
  const selected = editor.document.selectedObjects.at(-1);
  if (!selected) return null;
  const entries = (...actions: Action[]): MenuEntry[] => actions.map((action) => actionEntry(action, editor));
  return [
    { label: t('Add below'), icon: 'add', entries: addEntries(editor, selected) },
    ...['separator' as const, ...entries(cut, copy, paste, pasteBelow, duplicate, duplicateMany)],
    ...['separator' as const, ...entries(rename, group, ungroup, makePrefab, unpackPrefab, remove)],
    ...['separator' as const, ...entries(hide, lock, focus)],
  ];
}
