import type { CustomField } from '@farol/engine/fields';
import { createElement, type ReactNode } from 'react';
import type { FieldEditorProps } from '../api/FieldEditorProps';
import { useEditor, useSignal } from '../ui/EditorContext';
import { TechniqueEditor } from './TechniqueEditor';

/** The control of a field of a type of its own; the value as text where no plugin has brought a control. */
export function CustomEditor(props: FieldEditorProps<CustomField>): ReactNode {
  const { fieldEditors } = useEditor();
  useSignal(fieldEditors.changed);
  const known = fieldEditors.get(props.field.type.name);
  if (!known && props.field.type.name === 'technique') return <TechniqueEditor {...props} />;
  return known ? createElement(known.editor, props) : <span className="dim">{String(props.value)}</span>;
}
