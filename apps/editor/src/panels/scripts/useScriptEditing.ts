import type { EditorApi } from '../../api/EditorApi';
import { ScriptEditing } from '../../scripts/ScriptEditing';
import { useEditor, useSignal } from '../../ui/EditorContext';

const known = new WeakMap<EditorApi, ScriptEditing>();

/** Texts of an editor's scripts that are being edited. */
export function useScriptEditing(): ScriptEditing {
  const editor = useEditor();
  let editing = known.get(editor);
  if (!editing) known.set(editor, (editing = new ScriptEditing(editor.document)));
  useSignal(editing.changed);
  return editing;
}
