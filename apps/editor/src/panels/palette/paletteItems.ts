import { t } from '@farol/editing';
import { addCreation, libraryEntries } from '../../actions/addEntries';
import { type Action, labelOf } from '../../api/Action';
import { showPalette } from '../../actions/help';
import { allActions } from '../../actions';
import type { EditorApi } from '../../api/EditorApi';
import { creations } from '../../model/creations';
import type { IconName } from '../../style/iconPaths';
import { guideItems } from './guideItems';
import type { Findable } from './matchItems';

/** Number of lines shown in the command palette. */
export const LINES = 60;

/** A line of the command palette. */
export interface PaletteItem extends Findable {
  readonly id: string;
  readonly icon?: IconName;
  /** Keyboard shortcut shown at the right. */
  readonly keys?: string;
  /** Whether the item is the current choice, such as the technique in use. */
  readonly isCurrent?: boolean;
  run(): unknown;
}

const capital = (word: string): string => word.charAt(0).toUpperCase() + word.slice(1).replaceAll('-', ' ');

/** Group of an action, by the first part of its id. */
export const groupOf = (id: string): string => {
  if (id.startsWith('file.new.')) return t('Samples');
  const [first] = id.split('.');
  return t({ gizmo: 'Handles', shown: 'Show' }[first] ?? capital(first));
};

/** Maximum number of objects that a search may find; when there are more, none is listed. */
export const OBJECTS = 30;

/** Runs an action that was found: an action of a panel always opens the panel, even when it is in front already. */
function runFound(editor: EditorApi, action: Action): unknown {
  const panel = /^panels\.show\.(.+)$/.exec(action.id)?.[1];
  return panel === undefined ? action.run(editor) : editor.layout.open(panel);
}

/** Commands that are available now. */
export function paletteItems(editor: EditorApi): PaletteItem[] {
  const { document } = editor;
  const done = allActions(editor)
    .filter((action) => action.id !== showPalette.id && (action.enabled?.(editor) ?? true))
    .map((action): PaletteItem => ({
      id: action.id,
      label: labelOf(action, editor),
      group: groupOf(action.id),
      icon: action.icon,
      keys: editor.keys.keysOf(action).at(0),
      isCurrent: action.checked?.(editor),
      run: () => runFound(editor, action),
    }));
  const added = creations(document.scene).map((creation): PaletteItem => ({
    id: `add.${creation.folder ?? ''}.${creation.label}`,
    label: creation.label,
    group: creation.folder ? t('Add, {folder}', { folder: creation.folder }) : t('Add'),
    icon: 'add',
    run: () => addCreation(editor, creation, null),
  }));
  const ofLibrary = libraryEntries().map(({ id, label, folder, run }): PaletteItem => ({
    ...{ id: `add.library.${id}`, label, group: t('Add, {folder}', { folder }), icon: 'lamp' },
    run: () => run(editor),
  }));
  return [...done, ...added, ...ofLibrary, ...guideItems()];
}

export function objectItems(editor: EditorApi): PaletteItem[] {
  const { document, viewport } = editor;
  const items: PaletteItem[] = [];
  document.scene.traverse(({ id, name }) =>
    items.push({
      id: `object.${id}`,
      label: name,
      group: t('Select'),
      icon: 'object',
      run() {
        document.selection.set([id]);
        viewport.focus();
      },
    }),
  );
  return items;
}
