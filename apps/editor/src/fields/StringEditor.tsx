import type { StringField } from '@farol/engine/fields';
import type { ReactNode } from 'react';
import { TextInput } from '../ui/TextInput';
import type { FieldEditorProps } from '../api/FieldEditorProps';

export function StringEditor(props: FieldEditorProps<StringField>): ReactNode {
  const { value, label, description, disabled, onCommit } = props;
  return <TextInput value={value} label={label} description={description} disabled={disabled} onCommit={onCommit} />;
}
