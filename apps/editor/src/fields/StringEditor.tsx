import { t } from '@farol/editing';
import type { StringField } from '@farol/engine/fields';
import type { ReactNode } from 'react';
import { SelectBox, type SelectOption } from '../ui/SelectBox';
import { TextInput } from '../ui/TextInput';
import type { FieldEditorProps } from '../api/FieldEditorProps';

/** Any text; one of several where the owner says which there are. */
export function StringEditor(props: FieldEditorProps<StringField>): ReactNode {
  const { value, mixed, label, description, disabled, choices, onCommit } = props;
  if (!choices) {
    return <TextInput value={value} label={label} description={description} disabled={disabled} onCommit={onCommit} />;
  }
  const options: SelectOption<string>[] = [
    { value: '', label: t('None') },
    ...choices.map((choice) => ({ value: choice, label: choice })),
  ];
  if (value && !choices.includes(value)) options.push({ value, label: t('{name} (not there)', { name: value }) });
  return <SelectBox {...{ value: mixed ? null : value, options, label, description, disabled }} onChange={onCommit} />;
}
