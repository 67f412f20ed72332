import type { CustomField } from '@farol/engine/fields';
import { createElement, type ReactNode } from 'react';
import type { FieldEditorProps } from '../api/FieldEditorProps';
import { useEditor, useSignal } from '../ui/EditorContext';
import { TechniqueEditor } from './TechniqueEditor';

/** Control of a field of a custom type; the value as text when no plugin provides a control. */
export function CustomEditor(props: FieldEditorProps<CustomField>): ReactNode {
  const { fieldEditors } = useEditor();
  useSignal(fieldEditors.changed);
  const known = fieldEditors.get(props.field.type.name);
  if (!known && props.field.type.name === 'technique') return <TechniqueEditor {...props} />;
  return known ? createElement(known.editor, props) : <span className="dim">{String(props.value)}</span>;
}
