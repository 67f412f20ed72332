import type { EditorApi } from '../../api/EditorApi';
import { ScriptEditing } from '../../scripts/ScriptEditing';
import { useEditor, useSignal } from '../../ui/EditorContext';

const known = new WeakMap<EditorApi, ScriptEditing>();

/** The scripts of an editor as texts that are edited. */
export function useScriptEditing(): ScriptEditing {
  const editor = useEditor();
  let editing = known.get(editor);
  if (!editing) known.set(editor, (editing = new ScriptEditing(editor.document)));
  useSignal(editing.changed);
  return editing;
}
