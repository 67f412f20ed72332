import { t } from '@farol/editing';
import type { EditorApi } from '../../api/EditorApi';
import { assetEntry } from '../../files/assetKinds';
import type { MenuEntry } from '../../api/MenuEntry';
import { addScript, duplicateScript } from '../../model/scriptEdits';
import { removeEntries } from '../assets/assetDialogs';

/** Makes a script, and shows it. */
export function newScript(editor: EditorApi): void {
  const { command, name } = addScript(editor.document.scene, t('Script'));
  editor.commands.run(command);
  editor.openScript(name);
}

function duplicate(editor: EditorApi, script: string): void {
  const { command, name } = duplicateScript(editor.document.scene, script);
  editor.commands.run(command);
  editor.openScript(name);
}

async function remove(editor: EditorApi, script: string): Promise<void> {
  const entry = assetEntry(editor.document.scene, script);
  if (entry) await removeEntries(editor, [entry]);
}

/** Lines of the menu of a script. @param rename - has its name typed */
export function scriptMenu(editor: EditorApi, script: string, rename: () => void): MenuEntry[] {
  const attempt = (run: () => unknown) => (): void => editor.attempt(run);
  return [
    { label: t('Rename'), keys: 'F2', run: rename },
    { label: t('Duplicate'), icon: 'duplicate', run: attempt(() => duplicate(editor, script)) },
    'separator',
    { label: t('Delete…'), icon: 'remove', keys: 'Delete', run: attempt(() => remove(editor, script)) },
  ];
}

export { remove as removeScript };
