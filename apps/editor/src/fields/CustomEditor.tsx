import type { CustomField } from '@farol/engine/fields';
import { type ComponentType, createElement, type ReactNode } from 'react';
import type { FieldEditorProps } from './FieldEditorProps';

const editors = new Map<string, ComponentType<FieldEditorProps<CustomField>>>();

/** Gives the fields of a registered type their editor. */
export function setCustomEditor(type: string, editor: ComponentType<FieldEditorProps<CustomField>>): void {
  editors.set(type, editor);
}

/** The editor of a field of a type that a plugin has brought; its value as text where the plugin is not there. */
export function CustomEditor(props: FieldEditorProps<CustomField>): ReactNode {
  const editor = editors.get(props.field.type);
  return editor ? createElement(editor, props) : <span className="dim">{String(props.value)}</span>;
}
