import { t } from '@farol/editing';
import type { GameObject } from '@farol/engine';
import type { EditorApi } from '../api/EditorApi';
import { addScript } from '../model/scriptEdits';

/**
 * Adds a script, and opens it.
 * @param wanted - name with folder
 * @param users - objects that get the script's component
 * @returns the script's name
 */
export function newScript(editor: EditorApi, wanted = t('Script'), users: readonly GameObject[] = []): string {
  const { command, name } = addScript(editor.document.scene, wanted, users);
  editor.commands.run(command);
  // focuses the first line, so that the user can type at once
  editor.openScript(name, 1);
  return name;
}
