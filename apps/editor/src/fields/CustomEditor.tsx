import type { CustomField } from '@farol/engine/fields';
import { createElement, type ReactNode } from 'react';
import type { FieldEditorProps } from '../api/FieldEditorProps';
import { useEditor, useSignal } from '../ui/EditorContext';

/** The control of a field of a plugin's type; the value as text where no plugin has brought a control. */
export function CustomEditor(props: FieldEditorProps<CustomField>): ReactNode {
  const { fieldEditors } = useEditor();
  useSignal(fieldEditors.changed);
  const known = fieldEditors.get(props.field.type.name);
  return known ? createElement(known.editor, props) : <span className="dim">{String(props.value)}</span>;
}
