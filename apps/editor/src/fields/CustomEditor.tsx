import type { TechniqueName } from '@farol/renderer';
import { SelectBox } from '../ui/SelectBox';
import { techniqueOptions } from '../ui/techniqueOptions';
import type { CustomField } from '@farol/engine/fields';
import { createElement, type ReactNode } from 'react';
import type { FieldEditorProps } from '../api/FieldEditorProps';
import { useEditor, useSignal } from '../ui/EditorContext';

/** Control of a field of a custom type; the value as text when no plugin provides a control. */
export function CustomEditor(props: FieldEditorProps<CustomField>): ReactNode {
  const { fieldEditors } = useEditor();
  useSignal(fieldEditors.changed);
  const known = fieldEditors.get(props.field.type.name);
  if (!known && props.field.type.name === 'technique') return <TechniqueEditor {...props} />;
  return known ? createElement(known.editor, props) : <span className="dim">{String(props.value)}</span>;
}

/** Chooses a technique of the renderer, including those of plugins. */
function TechniqueEditor(props: FieldEditorProps<CustomField>): ReactNode {
  const { value, label, description, disabled, onCommit } = props;
  const { plugins, viewport } = useEditor();
  useSignal(plugins.changed);
  return (
    <SelectBox
      {...{ label, description, disabled }}
      value={value as TechniqueName | null}
      options={techniqueOptions(viewport.farol)}
      onChange={onCommit}
    />
  );
}
