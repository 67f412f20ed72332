import { t } from '@farol/editing';
import type { ChoiceField } from '@farol/engine/fields';
import type { ReactNode } from 'react';
import { SelectBox } from '../ui/SelectBox';
import type { FieldEditorProps } from '../api/FieldEditorProps';

/** Capitalises an option without a label of its own, such as 'point'. */
const capital = (text: string): string => text.charAt(0).toLocaleUpperCase() + text.slice(1);

export function ChoiceEditor(props: FieldEditorProps<ChoiceField>): ReactNode {
  const { field, value, label, description, disabled, onCommit } = props;
  const { optionLabels = {} } = field as ChoiceField<string>;
  const options = field.options.map((option) => ({ value: option, label: capital(t(optionLabels[option] ?? option)) }));
  return <SelectBox {...{ value, options, label, description, disabled }} onChange={onCommit} />;
}
