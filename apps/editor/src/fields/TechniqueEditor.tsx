import type { CustomField } from '@farol/engine/fields';
import type { TechniqueName } from '@farol/renderer';
import type { ReactNode } from 'react';
import type { FieldEditorProps } from '../api/FieldEditorProps';
import { useEditor, useSignal } from '../ui/EditorContext';
import { SelectBox } from '../ui/SelectBox';
import { techniqueOptions } from '../ui/techniqueOptions';

/** Chooses a technique of the renderer, including those of plugins. */
export function TechniqueEditor(props: FieldEditorProps<CustomField>): ReactNode {
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
