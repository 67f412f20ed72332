import { t } from '@farol/editing';
import type { EditorApi } from '../../api/EditorApi';
import { assetEntry } from '../../files/assetKinds';
import type { MenuEntry } from '../../api/MenuEntry';
import { addScriptComponent, duplicateScript } from '../../model/scriptEdits';
import { usagesOf } from '../../model/assetUsages';
import { removeEntries } from '../assets/assetDialogs';

export function duplicateAndShow(editor: EditorApi, script: string): void {
  const { command, name } = duplicateScript(editor.document.scene, script);
  editor.commands.run(command);
  editor.openScript(name);
}

export async function removeScript(editor: EditorApi, script: string): Promise<void> {
  const entry = assetEntry(editor.document.scene, script);
  if (entry) await removeEntries(editor, [entry]);
}

/** Selects the objects that have a component of a script. @throws Error when there are none */
function selectUsers({ document }: EditorApi, script: string): void {
  const ids = usagesOf(document.scene, script).flatMap(({ object }) => object ?? []);
  if (ids.length === 0) throw new Error(t('No object uses {name}.', { name: script }));
  document.selection.set([...new Set(ids)]);
}

/** Context menu of a script. @param rename - starts renaming in place */
export function scriptMenu(editor: EditorApi, script: string, rename: () => void): MenuEntry[] {
  const { document, commands } = editor;
  const attempt = (run: () => unknown) => (): void => editor.attempt(run);
  return [
    {
      label: t('Add to the selected objects'),
      icon: 'add',
      disabled: document.selectedObjects.length === 0,
      run: attempt(() => commands.run(addScriptComponent(document.scene, document.selectedObjects, script))),
    },
    { label: t('Select what uses it'), icon: 'select', run: attempt(() => selectUsers(editor, script)) },
    'separator',
    { label: t('Rename'), keys: 'F2', run: rename },
    { label: t('Duplicate'), icon: 'duplicate', run: attempt(() => duplicateAndShow(editor, script)) },
    'separator',
    { label: t('Delete…'), icon: 'remove', keys: 'Delete', run: attempt(() => removeScript(editor, script)) },
  ];
}
