import type { BooleanField } from '@farol/engine/fields';
import type { ReactNode } from 'react';
import { Toggle } from '../ui/Toggle';
import type { FieldEditorProps } from '../api/FieldEditorProps';

export function BooleanEditor(props: FieldEditorProps<BooleanField>): ReactNode {
  const { value, label, description, disabled, onCommit } = props;
  return <Toggle value={value} label={label} description={description} disabled={disabled} onChange={onCommit} />;
}
