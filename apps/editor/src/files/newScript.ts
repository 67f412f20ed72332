import { t } from '@farol/editing';
import type { GameObject } from '@farol/engine';
import type { EditorApi } from '../api/EditorApi';
import { addScript, type ScriptText } from '../model/scriptEdits';

/**
 * Adds a script, and opens it.
 * @param wanted - proposed name, with folder
 * @param users - objects that get the script's component
 * @param template - text that it begins with; a class with one field when absent
 * @returns the script's name
 */
export function newScript(
  editor: EditorApi,
  wanted = t('Script'),
  users: readonly GameObject[] = [],
  template?: ScriptText,
): string {
  const { command, name } = addScript(editor.document.scene, wanted, users, template);
  editor.commands.run(command);
  // focuses the first line, so that the user can type at once
  editor.openScript(name, 1);
  return name;
}
