import { t } from '@farol/editing';
import type { ChoiceField } from '@farol/engine/fields';
import type { ReactNode } from 'react';
import { SelectBox } from '../ui/SelectBox';
import type { FieldEditorProps } from '../api/FieldEditorProps';

export function ChoiceEditor(props: FieldEditorProps<ChoiceField>): ReactNode {
  const { field, value, label, description, disabled, onCommit } = props;
  const { optionLabels = {} } = field as ChoiceField<string>;
  const options = field.options.map((option) => ({ value: option, label: t(optionLabels[option] ?? option) }));
  return <SelectBox {...{ value, options, label, description, disabled }} onChange={onCommit} />;
}
