import { t } from '@farol/editing';
import type { GameObject } from '@farol/engine';
import type { EditorApi } from '../api/EditorApi';
import { addScript } from '../model/scriptEdits';

/**
 * Makes a script, and shows it.
 * @param wanted - its name, its folder in it
 * @param users - objects that get its component
 * @returns its name
 */
export function newScript(editor: EditorApi, wanted = t('Script'), users: readonly GameObject[] = []): string {
  const { command, name } = addScript(editor.document.scene, wanted, users);
  editor.commands.run(command);
  // its first line has the focus: what is typed next is of it
  editor.openScript(name, 1);
  return name;
}
